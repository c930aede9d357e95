#include "mutations.hpp"

#include <algorithm>
#include <array>
#include <random>

namespace packstone::fuzz {

namespace {

constexpr std::size_t longest_part = 64;  ///< [bytes] that one change moves
constexpr std::size_t most_changes = 4;

/// Words at which readers of numbers and of counts go wrong.
constexpr std::array words = {"0",          "-1",
                              "1e308",      "1e400",
                              "nan",        "inf",
                              "-inf",       "18446744073709551616",
                              "2147483648", "9223372036854775807",
                              ",",          "\n",
                              "\"",         "[",
                              "{",          "#",
                              "1,5",        " ",
                              "\t",         "\r\n",
                              "1e-320",     "0x10"};

class Mutation {
 public:
  Mutation(std::string bytes, std::uint64_t number) : bytes_(std::move(bytes)), random_(number) {}

  std::string result() {
    const std::size_t changes = 1 + below(most_changes);
    for (std::size_t k = 0; k < changes && !bytes_.empty(); ++k) change();
    return bytes_;
  }

 private:
  /// The standard's distributions differ between libraries.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  std::size_t place() { return below(bytes_.size()); }

  void change() {
    const std::size_t at = place(), count = std::min(1 + below(longest_part), bytes_.size() - at);
    switch (below(8)) {
      case 0:
        bytes_[at] = static_cast<char>(bytes_[at] ^ (1 << below(8)));
        break;
      case 1:
        bytes_[at] = static_cast<char>(below(256));
        break;
      case 2:
        bytes_.resize(at);
        break;
      case 3:
        bytes_.erase(at, count);
        break;
      case 4:
        bytes_.insert(place(), bytes_.substr(at, count));
        break;
      case 5:
        bytes_.insert(at, words[below(words.size())]);
        break;
      case 6:
        replace_number();
        break;
      default:
        bytes_.replace(at, count, std::string(count, static_cast<char>(below(2) ? 0xff : 0)));
    }
  }

  /// The digits from some place on by one of the words.
  void replace_number() {
    const std::size_t at = bytes_.find_first_of("0123456789", place());
    if (at == std::string::npos) return;
    const std::size_t end = std::min(bytes_.find_first_not_of("0123456789.eE+-", at), bytes_.size());
    bytes_.replace(at, end - at, words[below(words.size())]);
  }

  std::string bytes_;
  std::mt19937_64 random_;
};

}  // namespace

std::string mutated(const std::string& input, std::uint64_t number) { return Mutation(input, number).result(); }

}  // namespace packstone::fuzz
