// How places are spelt in C++.
#include "emit/places.h"

#include "compiled.h"
#include "syntax/parser.h"

#include <gtest/gtest.h>

namespace ladderc::test {
namespace {

class Places : public testing::Test {
protected:
  ir::Place place(llvm::StringRef word, OperandType type) const { return ir::to_place(parse_operand(family, word, {}), type); }
  std::string input(llvm::StringRef word, OperandType type = OperandType::Word) const {
    return emit::input_text(context, place(word, type));
  }
  std::string output(llvm::StringRef word, OperandType type = OperandType::Word) const {
    return emit::output_text(context, place(word, type));
  }
  std::string bit(llvm::StringRef word) const { return emit::bit_text(context, place(word, OperandType::Bit)); }

  const FamilyInfo &family = *find_family("melsec-qs");
  Parameters parameters = default_parameters(family, family.models.front());
  emit::PlaceContext context{family, parameters};
};

TEST_F(Places, SubscriptsShowTheDevicesOwnNumber) {
  EXPECT_EQ(bit("X9"), "X[9]");
  EXPECT_EQ(bit("XA"), "X[0xA]");
  EXPECT_EQ(bit("X10"), "X[0x10]");
  EXPECT_EQ(bit("M10"), "M[10]");
  EXPECT_EQ(bit("SM400"), "sys.SM[400]");
  EXPECT_EQ(bit("T5"), "T[5].contact");
  EXPECT_EQ(bit("D3.F"), "D.bit(3, 15)");
}

TEST_F(Places, WordsPairsAndQuads) {
  EXPECT_EQ(input("D5"), "D[5]");
  EXPECT_EQ(input("T5"), "T[5].value");
  EXPECT_EQ(input("D5", OperandType::DWord), "D.pair(5)");
  EXPECT_EQ(output("D5", OperandType::QWord), "D.quad(5)");
  EXPECT_EQ(output("D5", OperandType::WordTwice), "D[5], D[6]");
  EXPECT_EQ(output("D5", OperandType::DWordTwice), "D.pair(5), D.pair(7)");
  EXPECT_EQ(input("T5", OperandType::DWord), "pair(T[5].value, T[6].value)");
}

TEST_F(Places, Digits) {
  EXPECT_EQ(input("K4X10"), "X.word<4>(0x10)");
  EXPECT_EQ(input("K8M0", OperandType::DWord), "M.dword<8>(0)");
  EXPECT_EQ(output("K2Y0"), "Y.digits<2>(0)");
  EXPECT_EQ(input("K1M0", OperandType::WordBlock), "M.digit_block<1>(0)");
  EXPECT_EQ(input("D7", OperandType::WordBlock), "D.block(7)");
}

TEST_F(Places, WhatCrossesTheEndIsNamedWordByWord) {
  EXPECT_EQ(output("D6143", OperandType::DWord), "pair(D[6143], W[0])");
  EXPECT_EQ(output("D6142", OperandType::QWord), "quad(D[6142], D[6143], W[0], W[1])");
  EXPECT_EQ(input("K1M6142"), "digits_of(M[6142], M[6143], B[0], B[1]).word()");
}

TEST_F(Places, ConstantsKeepTheirForm) {
  EXPECT_EQ(input("K-5"), "-5");
  EXPECT_EQ(input("H64"), "0x0064");
  EXPECT_EQ(input("HFFFF"), "word(0xFFFF)");
  EXPECT_EQ(input("HFFFF", OperandType::DWord), "0x0000FFFF");
  EXPECT_EQ(input("H80000000", OperandType::DWord), "dword(0x80000000)");
  EXPECT_EQ(input("K-2147483648", OperandType::DWord), "dword(-2147483647 - 1)");
  EXPECT_EQ(input("K-32768"), "-32768");
}

TEST_F(Places, MemoriesOfTheProgram) {
  ir::Place edge, master;
  edge.kind = ir::PlaceKind::Edge;
  edge.number = 3;
  master.kind = ir::PlaceKind::Master;
  EXPECT_EQ(emit::bit_text(context, edge), "edge[3]");
  EXPECT_EQ(emit::bit_text(context, master), "master[0]");
}

}  // namespace
}  // namespace ladderc::test
