// Mnemonics by their spelling.
#include "interpreter.h"

#include <map>
#include <stdexcept>

namespace ladderc::differential {

namespace {

using Table = std::map<std::string, Decoded>;

void add_contacts(Table &table) {
  for (const auto &[word, join] : std::map<std::string, char>{{"LD", 'L'}, {"AND", 'A'}, {"OR", 'O'}}) {
    Decoded d;
    d.action = Action::Contact;
    d.join = join;
    table[word] = d;
    for (const char edge : {'P', 'F'}) {
      d.edge = edge;
      table[word + edge] = d;
    }
    d.edge = ' ';
    d.negated = true;
    table[word == "AND" ? "ANI" : word + "I"] = d;
    for (const char *sign : {"=", "<>", ">", "<=", "<", ">="})
      for (const bool wide : {false, true}) {
        Decoded c;
        c.action = Action::Compare;
        c.join = join;
        c.sign = sign;
        c.wide = wide;
        table[word + (wide ? "D" : "") + sign] = c;
      }
  }
}

void add_plain(Table &table) {
  const std::map<std::string, std::pair<Action, char>> plain = {
      {"ANB", {Action::AndBlock, ' '}},     {"ORB", {Action::OrBlock, ' '}},      {"MPS", {Action::Push, ' '}},
      {"MRD", {Action::Read, ' '}},         {"MPP", {Action::Pop, ' '}},          {"INV", {Action::Invert, ' '}},
      {"MEP", {Action::EdgeOfResult, 'P'}}, {"MEF", {Action::EdgeOfResult, 'F'}}, {"EGP", {Action::EdgeRelay, 'P'}},
      {"EGF", {Action::EdgeRelay, 'F'}},    {"OUT", {Action::Out, ' '}},          {"OUTH", {Action::OutFast, ' '}},
      {"SET", {Action::Set, ' '}},          {"RST", {Action::Reset, ' '}},        {"PLS", {Action::Pulse, 'P'}},
      {"PLF", {Action::Pulse, 'F'}},        {"FF", {Action::Toggle, 'P'}},        {"MC", {Action::Master, ' '}},
      {"MCR", {Action::MasterReset, ' '}},  {"NOP", {Action::Nothing, ' '}},      {"NOPLF", {Action::Nothing, ' '}},
      {"PAGE", {Action::Nothing, ' '}},     {"END", {Action::End, ' '}},          {"S.QSABORT", {Action::Abort, ' '}}};
  for (const auto &[word, what] : plain) {
    Decoded d;
    d.action = what.first;
    d.edge = what.second;
    table[word] = d;
  }
}

void add_word(Table &table, const std::string &narrow, const std::string &wide, WordOp op) {
  for (const bool pulsed : {false, true})
    for (const std::string *word : {&narrow, &wide}) {
      if (word->empty())
        continue;
      Decoded d;
      d.action = Action::Word;
      d.op = op;
      d.wide = word == &wide;
      d.pulsed = pulsed;
      table[*word + (pulsed ? "P" : "")] = d;
    }
}

Table make_table() {
  Table table;
  add_contacts(table);
  add_plain(table);
  const std::map<std::string, WordOp> same_name = {{"+", WordOp::Add},     {"-", WordOp::Subtract},    {"*", WordOp::Multiply},
                                                   {"/", WordOp::Divide},  {"INC", WordOp::Increment}, {"DEC", WordOp::Decrement},
                                                   {"BCD", WordOp::ToBcd}, {"BIN", WordOp::FromBcd},   {"NEG", WordOp::Negate},
                                                   {"MOV", WordOp::Move},  {"CML", WordOp::Complement}};
  for (const auto &[word, op] : same_name)
    add_word(table, word, "D" + word, op);
  add_word(table, "BMOV", "", WordOp::BlockMove);
  add_word(table, "FMOV", "", WordOp::Fill);
  const std::map<std::string, WordOp> logic = {
      {"AND", WordOp::And}, {"OR", WordOp::Or}, {"XOR", WordOp::Xor}, {"XNR", WordOp::Xnor}};
  for (const auto &[word, op] : logic)
    add_word(table, "W" + word, "D" + word, op);
  return table;
}

}  // namespace

Decoded decode_mnemonic(const std::string &spelling) {
  static const Table table = make_table();
  const auto found = table.find(spelling);
  if (found == table.end())
    throw std::runtime_error("the interpreter does not know " + spelling);
  return found->second;
}

}  // namespace ladderc::differential
