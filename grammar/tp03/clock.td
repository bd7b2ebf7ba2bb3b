// The calendar clock, F160-F167. Times are three words, hour, minute and second; not on the SR.

defvar WithClock = LargeModels;
defvar NoTime = "6706: an hour is not 0-23, or a minute or second not 0-59; nothing is written";

class TimeIn<string n> : BlockIn<n, 3, ValueWords>;
class TimeSum<string f> : MayFail<f, [0, 1, 2], [2]>;

let category = "clock", models = WithClock in {
let section = "F160", title = "Compare times", errors = [NoTime],
    description = "Of the three bits from D on, one comes ON and the others OFF: D where S1:S2:S3 (hour, minute, second) is later "
                  "than the time in S, S+1 and S+2, D+1 where they are equal, D+2 where it is earlier. OFF: the bits keep their "
                  "state." in
defm TCMP : Pulsed<"TCMP", 160, MayFail<"tcmp", [0, 1, 2, 3, 4], [4]>,
                   [Source<"S1", OpWord>, Source<"S2", OpWord>, Source<"S3", OpWord>, TimeIn<"S">, BitsOut<"D", 3>], 11,
                   "K10 K30 K50 D0 M0">;
let section = "F161", title = "Compare a time with a zone", errors = [NoTime],
    description = "Of the three bits from D on, one comes ON and the others OFF: D where the time in S is before that in S1, D+1 "
                  "where it lies from S1 to S2, D+2 where it is behind S2. With S1 later than S2, S1 is both limits. OFF: the bits "
                  "keep their state." in
defm TZCP : Pulsed<"TZCP", 161, MayFail<"tzcp", [0, 1, 2, 3], [3]>, [TimeIn<"S1">, TimeIn<"S2">, TimeIn<"S">, BitsOut<"D", 3>], 9,
                   "D20 D30 D0 M3">;
defvar TimeSumOperands = [TimeIn<"S1">, TimeIn<"S2">, BlockOut<"D", 3, ValueWords>];
let section = "F162", title = "Add times", errors = [NoTime],
    description = "D, D+1 and D+2 become the sum of the times in S1 and S2. From 24 hours on, 24 hours are taken off. M8022: that "
                  "was done. M8020: the result is 0:00:00. M8021 stays." in
defm TADD : Pulsed<"TADD", 162, TimeSum<"tadd">, TimeSumOperands, 7, "D10 D20 D30">;
let section = "F163", title = "Subtract times", errors = [NoTime],
    description = "D, D+1 and D+2 become the time in S1 less that in S2; below 0, 24 hours are added. M8022, as the manual has it: "
                  "that was done. M8020: the result is 0:00:00. M8021 stays." in
defm TSUB : Pulsed<"TSUB", 163, TimeSum<"tsub">, TimeSumOperands, 7, "D10 D20 D30">;
let section = "F166", title = "Read the clock",
    description = "D to D+6 become year (2000-2099), month, day, hour, minute, second and weekday (0 is Sunday), as D8018, D8017, "
                  "D8016, D8015, D8014, D8013 and D8019 show them." in
defm TRD : Pulsed<"TRD", 166, Acts<"trd", [0], [0]>, [BlockOut<"D", 7, ValueWords>], 3, "D0">;
let section = "F167", title = "Set the clock",
    errors = ["6706: no date of 2000-2099, no time of day, or the weekday is not 0-6; the clock stays"],
    description = "Sets the clock to the seven words from S on: year, month, day, hour, minute, second and weekday (0 is Sunday). "
                  "The new time is valid, and shown by D8013-D8019, at once. Written in every scan the clock stands still: the P "
                  "form is the usual one." in
defm TWR : Pulsed<"TWR", 167, MayFail<"twr", [0], []>, [BlockIn<"S", 7, ValueWords>], 3, "D10">;
}
