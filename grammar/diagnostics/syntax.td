// Messages about the words of a list line.

class TP<string sec, string c = ""> : Ref<"tp03", sec, c>;

def UnknownMnemonic : Error<"unknown-mnemonic", "'{word}' is no instruction of {family}"> {
  let explanation = "The word stands where an instruction begins, and the instruction tables of the family have no such mnemonic. "
    "The words behind it were taken for its operands and not looked at. 'ladderc instructions --family F' lists what exists.";
  let wrong = "LD X0\nOUTT Y0\nEND\n";
  let right = "LD X0\nOUT Y0\nEND\n";
  let references = [Ref<"melsec-qs", "9.1.6", "4000">, TP<"7.4", "6506">];
}
def NearestMnemonic : Note<"nearest-mnemonic", "the nearest one is '{name}'">;
def OtherFamily : Note<"other-family", "{family} has it">;

def OperandUnreadable : Error<"operand-unreadable", "'{word}' is no device or constant of {family}"> {
  let explanation = "An operand is a device (letters and a number), a bit of a word device (D0.5), digits of a bit device (K4X10), or a "
    "constant (K100, HFF). The word is none of these with the devices that the family has.";
  let wrong = "LD Q5\nOUT Y0\nEND\n";
  let right = "LD X5\nOUT Y0\nEND\n";
  let references = [TP<"7.4", "6501">];
}

def DeviceNumberMissing : Error<"device-number-missing", "'{word}' has no number behind {device}"> {
  let explanation = "A device is its letters and a number without a blank between them.";
  let wrong = "LD X\nOUT Y0\nEND\n";
  let right = "LD X0\nOUT Y0\nEND\n";
  let references = [TP<"7.4", "6501">];
}

def DigitNotInRadix : Error<"digit-not-in-radix", "'{word}' has the digit {digit}; {device} is followed by a number in {radix}"> {
  let explanation = "Numbers of some devices count in decimal, of others in hexadecimal or octal. The marked character is none of the "
    "digits that the number of this device may have.";
  let wrong = "LD M1F\nOUT Y0\nEND\n";
  let right = "LD M15\nOUT Y0\nEND\n";
  let references = [TP<"2.2", "6505">];
}

def DigitCountIndexed : Error<"digit-count-indexed", "'{word}' modifies the number of digits by an index register; only the device can be"> {
  let explanation = "An index register changes which device an operand names (K4M0Z0 begins at M0 plus Z0). How many digits there are "
    "is a part of the instruction and stays as written.";
  let family = "tp03";
  let wrong = "LD X0\nMOV K1 K0Z0M0\nEND\n";
  let right = "LD X0\nMOV K1 K4M0Z0\nEND\n";
  let references = [TP<"5.3", "6501">];
}

def ConstantSyntax : Error<"constant-syntax", "'{word}' is no constant; write K with a decimal or H with a hexadecimal number"> {
  let explanation = "A decimal constant is K, an optional minus and decimal digits: K100, K-5. A hexadecimal constant is H and "
    "hexadecimal digits: HFF. A number alone is not a constant.";
  let wrong = "LD X0\nOUT T0 100\nEND\n";
  let right = "LD X0\nOUT T0 K100\nEND\n";
  let references = [TP<"2.1", "6501">];
}

def NumberTooLarge : Error<"number-too-large", "the number in '{word}' is larger than that of any device or constant"> {
  let explanation = "The number does not fit in 64 bits as a constant, in 32 bits as a device number, or in 8 bits as the number of an "
    "index register.";
  let wrong = "LD M99999999999\nOUT Y0\nEND\n";
  let right = "LD M99\nOUT Y0\nEND\n";
  let references = [TP<"7.4", "6505">];
}

def BitNumber : Error<"bit-number", "'{word}' names bit {bit}; bits of a word are 0 to F"> {
  let explanation = "The bit behind the point is a hexadecimal number from 0 to F, with or without a leading zero.";
  let wrong = "LD D0.10\nOUT Y0\nEND\n";
  let right = "LD D0.A\nOUT Y0\nEND\n";
  let references = [TP<"7.4", "6501">];
}

def UnsupportedConstant : Error<"unsupported-constant", "{word} is a {kind} constant, which {family} does not have"> {
  let explanation = "Other controllers of the maker have real numbers (E1.5) and strings in quotes as constants. No instruction of this "
    "family takes one.";
  let wrong = "LD X0\nMOV E1.5 D0\nEND\n";
  let right = "LD X0\nMOV K1 D0\nEND\n";
  let references = [TP<"2.1", "6501">];
}

def StrayOperand : Error<"stray-operand", "'{word}' belongs to no instruction"> {
  let explanation = "Operands may stand on lines of their own behind their instruction. Here no instruction stands before, or the one "
    "before has all the operands that it can take.";
  let wrong = "LD X0\nX5\nOUT Y0\nEND\n";
  let right = "LD X0\nAND X5\nOUT Y0\nEND\n";
  let references = [TP<"7.4", "6501">];
}
