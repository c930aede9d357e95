#include "core/checkpoints.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace packstone {

namespace {

constexpr const char* head_part = "head";

}  // namespace

std::vector<FoundCheckpoint> Checkpoints::find() const {
  std::vector<FoundCheckpoint> found;
  for (int k = 0; k < count; ++k) {
    FoundCheckpoint one;
    one.file = file(k);
    if (!std::filesystem::exists(one.file)) continue;
    try {
      CheckpointReader reader(one.file);
      reader.begin(head_part);
      reader(one.head);
    } catch (const InputError& error) {
      one.fault = error.what();
    }
    found.push_back(std::move(one));
  }
  return found;
}

std::optional<FoundCheckpoint> Checkpoints::newest(const std::vector<FoundCheckpoint>& found) {
  std::optional<FoundCheckpoint> newest;
  for (const FoundCheckpoint& one : found) {
    if (one.fault.empty() && (!newest || one.head.moment > newest->head.moment)) newest = one;
  }
  return newest;
}

void Checkpoints::keep(const FoundCheckpoint& checkpoint) { next_ = checkpoint.file == file(0) ? 1 : 0; }

void Checkpoints::write(CheckpointHead head, const std::function<void(Archive&)>& state) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) throw RunError(folder_.string() + ": cannot be made: " + error.message());
  CheckpointWriter writer(file(next_));
  writer.begin(head_part);
  writer(head);
  state(writer);
  writer.commit();
  next_ = (next_ + 1) % count;
}

}  // namespace packstone
