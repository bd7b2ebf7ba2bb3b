// Bytes as a parameter file.
#include "sema/parameters.h"

#include <cstdlib>

using namespace ladderc;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const FamilyInfo &family = *find_family("melsec-qs");
  Parameters parameters = default_parameters(family, "");
  if (read_parameters({reinterpret_cast<const char *>(data), size}, family, parameters))
    return 0;
  for (const DeviceRange &range : parameters.latched)
    if (range.first > range.last || range.last >= parameters.points[range.device])
      std::abort();
  return 0;
}
