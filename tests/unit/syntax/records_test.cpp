// The examples of the message records: the wrong list gets the message, the right one does not.
#include "parsing.h"

#include <gtest/gtest.h>

namespace ladderc {
namespace {

class MessageRecord : public testing::TestWithParam<DiagId> {};

bool reports(llvm::StringRef list, DiagId id) {
  const llvm::StringRef family = info(id).family;
  Parsed parsed(list.str(), ListFormat::Auto, family.empty() ? qs() : *find_family(family));
  for (const Diagnostic &diagnostic : parsed.diagnostics.sorted()) {
    EXPECT_FALSE(llvm::StringRef(diagnostic.message).contains('{')) << diagnostic.message;
    if (diagnostic.id == id)
      return true;
  }
  return false;
}

TEST_P(MessageRecord, ItsExamplesAreTrue) {
  const DiagInfo &record = info(GetParam());
  EXPECT_TRUE(reports(record.wrong, GetParam())) << record.wrong.str();
  EXPECT_FALSE(reports(record.right, GetParam())) << record.right.str();
}

INSTANTIATE_TEST_SUITE_P(OfReadersAndParser, MessageRecord,
                         testing::Values(DiagId::DamagedText, DiagId::UnclosedQuote, DiagId::UnknownDirective, DiagId::UnknownAllow,
                                         DiagId::AllowNotWarning, DiagId::UnknownMnemonic, DiagId::OperandUnreadable,
                                         DiagId::DeviceNumberMissing, DiagId::DigitNotInRadix, DiagId::DigitCountIndexed,
                                         DiagId::ConstantSyntax, DiagId::NumberTooLarge, DiagId::BitNumber,
                                         DiagId::UnsupportedConstant, DiagId::StrayOperand),
                         [](const testing::TestParamInfo<DiagId> &id) {
                           std::string name = ladderc::info(id.param).id.str();
                           for (char &c : name)
                             c = c == '-' ? '_' : c;
                           return name;
                         });

}  // namespace
}  // namespace ladderc
