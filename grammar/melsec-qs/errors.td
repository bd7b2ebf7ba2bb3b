def E4100 : ErrorCode<4100,"a","b","c",1,"9">; def E4101 : ErrorCode<4101,"a","b","c",1,"9">; def SM722 : Special<"SM722","a","b",1,1,"app">;
