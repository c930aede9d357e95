#include "core/hash.hpp"

#include <cstdint>

#include <fmt/format.h>

namespace packstone {

std::string content_hash(std::string_view bytes) {
  constexpr std::uint64_t fnv_offset = 0xcbf29ce484222325ull, fnv_prime = 0x100000001b3ull;
  std::uint64_t hash = fnv_offset;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * fnv_prime;
  return fmt::format("{:016x}", hash);
}

}  // namespace packstone
