// The messages of ladderc. compiler/support/diagnostics.h says how they are reported; docs/diagnostics.md is made from these
// records.
//
// Text: lower case first letter unless it begins with a mnemonic or device, no full stop; say what is there and, if needed, the
// rule. {name} is an argument. The record's name is the C++ enumerator, the id is public and never changes its meaning.

class Ref<string fam, string sec, string c = ""> { string family = fam; string section = sec; string plc = c; }

class Diagnostic<string i, string sev, string text> {
  string id = i;
  string severity = sev;    // "Error", "Warning", "Note"
  string message = text;
  string explanation = "";
  string family = "";       // of the lists, where it is not melsec-qs
  string wrong = "";        // a list that gets the message; a test compiles it
  string right = "";        // the same put right; a test compiles it without this message
  list<Ref> references = [];
}
class Error<string i, string text> : Diagnostic<i, "Error", text>;
class Warning<string i, string text> : Diagnostic<i, "Warning", text>;
class Note<string i, string text> : Diagnostic<i, "Note", text>;

include "diagnostics/source.td"
include "diagnostics/syntax.td"
include "diagnostics/sema.td"
include "diagnostics/flow.td"
