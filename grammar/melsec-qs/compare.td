// Comparison contacts.

let section = "6.1.1-6.1.2" in {
let title = "Comparison contact, equal",
    description = "A contact that is ON while S1 equals S2. Both are signed numbers of 16 bits, with D of 32. AND puts it in "
                  "series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with the top "
                  "bit set is negative." in
defm Equal : Compare<"=", "equal", 400, 350, 500, 400>;
let title = "Comparison contact, not equal",
    description = "A contact that is ON while S1 differs from S2. Both are signed numbers of 16 bits, with D of 32. AND puts it in "
                  "series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with the top "
                  "bit set is negative." in
defm NotEqual : Compare<"<>", "not_equal", 400, 350, 500, 400>;
let title = "Comparison contact, greater",
    description = "A contact that is ON while S1 is greater than S2. Both are signed numbers of 16 bits, with D of 32. AND puts it "
                  "in series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with the "
                  "top bit set is negative." in
defm Greater : Compare<">", "greater", 400, 350, 500, 400>;
let title = "Comparison contact, less or equal",
    description = "A contact that is ON while S1 is less than or equal to S2. Both are signed numbers of 16 bits, with D of 32. "
                  "AND puts it in series, OR in parallel. Digits that are narrower than the number count as positive; an H "
                  "constant with the top bit set is negative." in
defm LessEqual : Compare<"<=", "less_equal", 400, 350, 500, 400>;
let title = "Comparison contact, less",
    description = "A contact that is ON while S1 is less than S2. Both are signed numbers of 16 bits, with D of 32. AND puts it in "
                  "series, OR in parallel. Digits that are narrower than the number count as positive; an H constant with the top "
                  "bit set is negative." in
defm Less : Compare<"<", "less", 400, 350, 500, 400>;
let title = "Comparison contact, greater or equal",
    description = "A contact that is ON while S1 is greater than or equal to S2. Both are signed numbers of 16 bits, with D of 32. "
                  "AND puts it in series, OR in parallel. Digits that are narrower than the number count as positive; an H "
                  "constant with the top bit set is negative." in
defm GreaterEqual : Compare<">=", "greater_equal", 400, 350, 500, 400>;
}
