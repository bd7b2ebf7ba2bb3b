// Messages about decoding a list and reading its lines.

def DamagedText : Warning<"damaged-text", "{count} places of this text could not be decoded; the first is here"> {
  let explanation = "Some bytes have no meaning in the encoding that was recognised. Each was replaced by the sign U+FFFD. In a "
    "comment that does no harm; in an instruction it makes a word unreadable. Usually the file was cut, or its encoding was not "
    "recognised: name it with --encoding, or save the list as UTF-8.";
  let wrong = "; motor �\nLD X0\nOUT Y0\nEND\n";
  let right = "; motor\nLD X0\nOUT Y0\nEND\n";
}

def UnclosedQuote : Warning<"unclosed-quote", "the quoted cell '{text}' does not end on its row"> {
  let explanation = "A cell of a table begins with a double quote, and no quote closes it before the end of the row. The cell was "
    "taken to end there, so that the rows behind it are read as they stand. Programs that lose quotes usually are spreadsheets: "
    "export the table again, or remove the single quote.";
  let wrong = "1,,LD,X0\n2,,OUT,Y0\n3,\"motor on,,\n3,,END,\n";
  let right = "1,,LD,X0\n2,,OUT,Y0\n3,\"motor on\",,\n3,,END,\n";
}

def UnknownDirective : Warning<"unknown-directive", "'{text}' is no directive; the only one is allow ID"> {
  let explanation = "A comment that begins with 'ladderc:' speaks to the compiler. It knows one sentence: allow, and behind it one or "
    "more ids of warnings, parted by blanks or commas. On a line of its own it holds for the next line with an instruction; behind an "
    "instruction it holds for that line.";
  let wrong = "; ladderc: ignore double-coil\nLD X0\nOUT Y0\nEND\n";
  let right = "; ladderc: allow double-coil\nLD X0\nOUT Y0\nEND\n";
}

def UnknownAllow : Warning<"unknown-allow", "no message has the id '{id}'"> {
  let explanation = "A 'ladderc: allow' comment names an id that no message has, so that it allows nothing. The id of a message stands "
    "in brackets at its end.";
  let wrong = "; ladderc: allow dubble-coil\nLD X0\nOUT Y0\nEND\n";
  let right = "; ladderc: allow double-coil\nLD X0\nOUT Y0\nEND\n";
}

def AllowNotWarning : Warning<"allow-not-warning", "'{id}' is no warning; only warnings can be allowed"> {
  let explanation = "A 'ladderc: allow' comment can silence a warning. An error tells that the list is no program of this controller; "
    "it cannot be allowed away.";
  let wrong = "; ladderc: allow unknown-mnemonic\nLD X0\nOUT Y0\nEND\n";
  let right = "LD X0\nOUT Y0\nEND\n";
}
