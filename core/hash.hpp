// A fingerprint of contents, to tell whether two runs had the same input.
#pragma once

#include <string>
#include <string_view>

namespace packstone {

/// 16 hex digits, FNV-1a of 64 bits: they tell versions of a file apart, they do not protect against forgery.
std::string content_hash(std::string_view bytes);

}  // namespace packstone
