#include "core/run_verdict.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace packstone {

namespace {

/// In the order of FailureKind.
constexpr std::array kind_names = {"not-a-number",  "particle-too-fast", "particle-lost",      "wall-crossed",
                                   "overlap",       "boundary-too-fast", "energy-growth",      "overdamped-instability",
                                   "step-too-long", "non-convergence",   "filling-incomplete", "formula-not-a-number",
                                   "account-open"};

constexpr std::size_t most_told = 4;  ///< of those that touch, in the message

std::string told_touching(const std::vector<NamedParticle>& particles) {
  std::string text;
  for (std::size_t k = 0; k < std::min(particles.size(), most_told); ++k) {
    text += fmt::format("{}{} ({})", k ? ", " : "", particles[k].id, particles[k].group);
  }
  if (particles.size() > most_told) text += fmt::format(" and {} more", particles.size() - most_told);
  return text;
}

}  // namespace

const char* to_string(FailureKind kind) { return kind_names[static_cast<std::size_t>(kind)]; }

FailureKind failure_kind_named(const std::string& name) {
  const auto found = std::find(kind_names.begin(), kind_names.end(), name);
  if (found == kind_names.end()) throw InputError("a failure of an unknown kind, \"" + name + "\"");
  return static_cast<FailureKind>(found - kind_names.begin());
}

std::string told(const NamedParticle& particle) { return fmt::format("particle {} ({})", particle.id, particle.group); }

std::string told(const Vec3& place) { return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", place[0], place[1], place[2]); }

std::string RunVerdict::message() const {
  std::string text;
  if (time) text = fmt::format("t = {:.6g} s{}: ", *time, step ? fmt::format(", step {}", *step) : "");
  text += what;
  if (!touching.empty()) text += "; in contact with " + told_touching(touching);
  for (const std::string* part : {&cause, &advice}) {
    if (!part->empty()) text += "; " + *part;
  }
  return text;
}

}  // namespace packstone
