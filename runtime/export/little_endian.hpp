// Numbers as the little-endian bytes of binary files, whatever the machine's own order.
#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace toile {

inline void append(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<char>((value >> shift) & 0xffU));
}
inline void append(std::string& bytes, std::int32_t value) {
  append(bytes, static_cast<std::uint32_t>(value));
}
inline void append(std::string& bytes, float value) {
  append(bytes, std::bit_cast<std::uint32_t>(value));
}

}  // namespace toile
