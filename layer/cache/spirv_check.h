#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace anteroom::cache {

// Whether bytes can be SPIR-V that a driver survives being handed: a header as glslang writes it,
// instructions that end where the module ends. What they say is guarded by the row's checksum.
bool plausibleSpirv(std::span<const std::byte> bytes);

}  // namespace anteroom::cache
