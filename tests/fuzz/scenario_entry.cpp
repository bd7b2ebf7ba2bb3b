// Bytes as a scenario file. Scenarios that name a list file are left out: the bytes must not choose what is opened.
#include "driver/scenario.h"

#include <sys/mman.h>
#include <unistd.h>

using namespace ladderc;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const llvm::StringRef text(reinterpret_cast<const char *>(data), size);
  if (text.contains("list") || text.contains('\\'))
    return 0;
  const int file = memfd_create("scenario", 0);
  if (write(file, data, size) == static_cast<ssize_t>(size)) {
    std::vector<driver::Scenario> scenarios;
    if (!driver::read_scenarios("/proc/self/fd/" + std::to_string(file), scenarios)) {
      const FamilyInfo &family = *find_family("melsec-qs");
      for (const driver::Scenario &s : scenarios) {
        Parameters parameters = default_parameters(family, "");
        (void)read_parameters(s.parameters, family, parameters);
      }
    }
  }
  close(file);
  return 0;
}
