#include "cli/render_overlay.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "analysis/forces/force_chains.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "core/text.hpp"
#include "viz/cut_away.hpp"

namespace packstone::cli {

namespace {

const std::vector<std::string> shown_names = {"all", "shrunk", "hidden"};  // in the order of viz::Shown

[[noreturn]] void refuse_trajectories(const std::string& text) {
  throw InputError(
      fmt::format("--trajectories {}: expected particle ids, 17,23, a number of them, random:20, or where they end, "
                  "\"x>0.3,y<0.2\"",
                  text));
}

std::vector<std::int64_t> ids_in(const std::string& text, std::size_t first) {
  std::vector<std::int64_t> ids;
  for (std::size_t comma = 0; comma != std::string::npos; first = comma + 1) {
    comma = text.find(',', first);
    const std::string word = text.substr(first, comma - first);
    std::int64_t id = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), id);
    if (error != std::errc() || end != word.data() + word.size() || id < 0) refuse_trajectories(text);
    ids.push_back(id);
  }
  return ids;
}

/// Ids of the particles that a text chooses: "17,23,99", "random:20" or half spaces.
std::vector<std::int64_t> particles_chosen(const std::string& text, const Snapshot& last) {
  const std::string random = "random:";
  std::vector<std::int64_t> there = last.id;
  std::sort(there.begin(), there.end());
  if (text.starts_with(random)) {
    const auto count = static_cast<std::size_t>(ids_in(text, random.size()).front());
    Random order(0, RandomStream::followed_particles, 0);
    shuffle(there, order);
    there.resize(std::min(count, there.size()));
    std::sort(there.begin(), there.end());
    return there;
  }
  if (text.find_first_of("<>") != std::string::npos) {
    const viz::CutAway region = viz::cut_from_text(text);
    std::vector<std::int64_t> inside;
    for (std::size_t row = 0; row < last.size(); ++row) {
      if (viz::is_cut_away(region, last.position[row])) inside.push_back(last.id[row]);
    }
    if (inside.empty()) throw InputError(fmt::format("--trajectories {}: no particle is there at the end", text));
    return inside;
  }
  const std::vector<std::int64_t> ids = ids_in(text, 0);
  for (const std::int64_t id : ids) {
    if (!std::binary_search(there.begin(), there.end(), id)) {
      throw InputError(fmt::format("--trajectories: there is no particle {}; ids go from {} to {}", id,
                                   there.empty() ? 0 : there.front(), there.empty() ? 0 : there.back()));
    }
  }
  return ids;
}

/// The links of all force chains.
viz::SegmentSet chain_links(const Snapshot& snapshot) {
  if (!snapshot.contacts) {
    throw InputError(
        "the snapshot has no contacts for force chains; ask the run for them with contacts = true of "
        "[output]");
  }
  const analysis::ForceNetwork network = analysis::force_network(snapshot);
  viz::SegmentSet set{"contact force [N]", {}};
  for (const analysis::ChainLink& link : analysis::force_chains(snapshot, network, {}).links) {
    const Vec3& from = snapshot.position[link.first];
    set.segments.push_back({from, snapshot.domain.separation(snapshot.position[link.second], from),
                            snapshot.contacts->force[link.contact].norm()});
  }
  return set;
}

}  // namespace

void add_overlay_options(Verb& verb, OverlayCall& call) {
  constexpr double widest = 5, longest = 1000;  // mean radii
  constexpr int longest_tail = 1'000'000;
  verb.add("--particles", call.particles,
           "all, shrunk or hidden [all; shrunk among arrows, hidden with contacts, chains and trajectories]");
  verb.add_flag("--contacts", call.contacts, "Tubes along all contacts, by force");
  verb.add_flag("--chains", call.chains, "Tubes along force chains, by force");
  verb.add("--force-scale", call.look.thickest_force, "Force of the thickest tube [N] [1 % are above it]").positive();
  verb.add("--tube-width", call.look.link_width, "Radius of the thickest tube, in mean particle radii")
      .between(0.0, widest)
      .shows_default();
  verb.add("--arrows", call.arrows, "Arrows of velocity, force, acceleration, or another field of vectors");
  verb.add("--arrow-scale", call.look.longest_arrow, "Value of an arrow of full length, SI [the largest of all frames]")
      .positive();
  verb.add("--arrow-length", call.look.arrow_length, "Full length, in mean particle radii")
      .between(0.0, longest)
      .shows_default();
  verb.add("--trajectories", call.trajectories, "Ways of particles: ids 17,23, random:20, or \"x>0.3,y<0.2\"");
  verb.add("--tail", call.tail, "Snapshots back that trajectories reach").between(1, longest_tail).shows_default();
}

void take_overlay(const OverlayCall& call, viz::PictureOptions& picture) {
  picture.look = call.look;
  if (call.contacts && call.chains)
    throw InputError("--contacts draws the contacts of --chains, too; take one of them");
  if (call.particles.empty()) {
    const bool lines = call.contacts || call.chains || !call.trajectories.empty();
    picture.shown = lines ? viz::Shown::hidden : !call.arrows.empty() ? viz::Shown::shrunk : viz::Shown::all;
    return;
  }
  const auto found = std::find(shown_names.begin(), shown_names.end(), call.particles);
  if (found == shown_names.end()) {
    throw InputError(fmt::format("--particles {}: expected {}", call.particles, joined(shown_names)));
  }
  picture.shown = static_cast<viz::Shown>(found - shown_names.begin());
}

OverlayMaker::OverlayMaker(const OverlayCall& call, const RunReader& run, const std::vector<std::size_t>& frames)
    : call_(call) {
  if (!call_.trajectories.empty()) read_paths(run, frames);
}

void OverlayMaker::read_paths(const RunReader& run, const std::vector<std::size_t>& frames) {
  const ReadOptions places_only{.region = {}, .contacts = false, .fields = false};
  followed_ = particles_chosen(call_.trajectories, run.snapshot(frames.back(), places_only));
  const auto tail = static_cast<std::size_t>(call_.tail);
  first_read_ = frames.front() > tail ? frames.front() - tail : 0;
  std::map<std::int64_t, std::size_t> index_of;
  for (std::size_t k = 0; k < followed_.size(); ++k) index_of.emplace(followed_[k], k);
  for (std::size_t index = first_read_; index <= frames.back(); ++index) {
    const Snapshot snapshot = run.snapshot(index, places_only);
    auto& places = places_.emplace_back(followed_.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
    for (std::size_t row = 0; row < snapshot.size(); ++row) {
      const auto followed = index_of.find(snapshot.id[row]);
      if (followed != index_of.end()) places[followed->second] = snapshot.position[row];
    }
  }
}

bool OverlayMaker::needs_common_scale() const {
  return (needs_contacts() && call_.look.thickest_force == 0) || (needs_fields() && call_.look.longest_arrow == 0);
}

viz::Overlay OverlayMaker::of(const Snapshot& snapshot, std::size_t index) const {
  viz::Overlay overlay;
  if (call_.contacts) overlay.links = viz::contact_links(snapshot);
  if (call_.chains) overlay.links = chain_links(snapshot);
  if (!call_.arrows.empty()) overlay.arrows = viz::arrows_of(snapshot, call_.arrows);
  const auto tail = static_cast<std::size_t>(call_.tail);
  const std::size_t first = std::max(first_read_, index > tail ? index - tail : 0);
  for (std::size_t k = 0; k < followed_.size(); ++k) {
    viz::Path path{followed_[k], {}};
    for (std::size_t i = first; i <= index; ++i) {
      const Vec3& place = places_[i - first_read_][k];
      if (place.allFinite()) path.points.push_back(place);
    }
    overlay.paths.push_back(std::move(path));
  }
  return overlay;
}

}  // namespace packstone::cli
