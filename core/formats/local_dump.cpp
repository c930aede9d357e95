#include "core/formats/local_dump.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/formats/lammps_dump.hpp"
#include "core/formats/mapped_file.hpp"
#include "core/text.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

constexpr double largest_id = 9007199254740992.0;  ///< 2^53: beyond it doubles skip whole numbers

const std::vector<std::string> known_names = {"id1", "id2", "x1", "y1",  "z1",  "x2",  "y2", "z2",
                                              "fx",  "fy",  "fz", "ftx", "fty", "ftz", "-"};

/// What LIGGGHTS' compute pair/gran/local writes, in its fixed order, and the least that one can do with.
const std::map<std::size_t, const char*> usual_names = {{5, "id1 id2 fx fy fz"},
                                                        {6, "id1 id2 - fx fy fz"},
                                                        {9, "x1 y1 z1 x2 y2 z2 fx fy fz"},
                                                        {12, "x1 y1 z1 x2 y2 z2 id1 id2 - fx fy fz"}};

std::vector<std::string> usual(std::size_t count) {
  std::vector<std::string> names;
  const auto found = usual_names.find(count);
  if (found == usual_names.end()) return names;
  for (const std::string_view name : words(found->second)) names.emplace_back(name);
  return names;
}

std::vector<std::string> meanings(const DumpFrame& frame, const std::string& source,
                                  const std::vector<std::string>& given) {
  const auto is_known = [](const std::string& name) {
    return std::find(known_names.begin(), known_names.end(), name) != known_names.end();
  };
  std::vector<std::string> names = given;
  if (names.empty() && std::any_of(frame.columns.begin(), frame.columns.end(), is_known)) {
    for (const std::string& name : frame.columns) names.push_back(is_known(name) ? name : "-");
  }
  if (names.empty()) names = usual(frame.columns.size());
  const std::int64_t head = frame.first_line - 1;
  if (names.empty()) {
    fail_at(source, head,
            fmt::format("the {} columns do not say what they are; name them with --contact-columns, out of {}",
                        frame.columns.size(), joined(known_names)));
  }
  if (names.size() != frame.columns.size()) {
    fail_at(source, head,
            fmt::format("the file has {} columns, --contact-columns names {}; they must agree (- for one "
                        "that is not used)",
                        frame.columns.size(), names.size()));
  }
  for (const std::string& name : names) {
    if (!is_known(name)) {
      fail_at(source, head, fmt::format("\"{}\" is no column of contacts; there are: {}", name, joined(known_names)));
    }
  }
  return names;
}

const DumpFrame& frame_of_step(const std::vector<DumpFrame>& frames, const std::string& source, std::int64_t step) {
  const auto found = std::find_if(frames.begin(), frames.end(), [&](const DumpFrame& f) { return f.step == step; });
  if (found == frames.end()) {
    throw InputError(fmt::format("{}: has no contacts of step {}; its steps go from {} to {}", source, step,
                                 frames.front().step, frames.back().step));
  }
  if (!found->local)
    fail_at(source, found->first_line - 1, "holds particles, not contacts; a dump of style local is needed");
  return *found;
}

using Columns = std::array<const std::vector<double>*, 3>;

bool whole(const Columns& columns) { return columns[0] && columns[1] && columns[2]; }

/// Components that the file does not have are 0.
Vec3 vector_of(const Columns& columns, std::size_t row) {
  Vec3 value = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (columns[axis]) value[axis] = (*columns[axis])[row];
  }
  return value;
}

/// -1, which no particle has, for what is no id.
std::int64_t id_of(double value) { return value >= 0 && value < largest_id ? static_cast<std::int64_t>(value) : -1; }

}  // namespace

PairForces read_local_dump(const std::filesystem::path& path, std::int64_t step,
                           const std::vector<std::string>& column_names) {
  const MappedFile file(path);
  const std::string source = path.string();
  if (!is_lammps_dump(file.text())) throw InputError(source + ": is no dump of contacts; it would begin with ITEM:");
  const std::vector<DumpFrame> frames = index_dump(file.text(), source);
  const DumpFrame& frame = frame_of_step(frames, source, step);
  const std::vector<std::string> names = meanings(frame, source, column_names);
  std::vector<RowColumn> wanted;
  for (const auto& name : names) {
    wanted.push_back({name, name == "-" ? RowColumn::Kind::skipped : RowColumn::Kind::number});
  }
  const Rows rows = read_rows({file.text().substr(frame.first_byte), source, frame.first_line}, frame.count, wanted);
  const auto column = [&](const std::string& name) -> const std::vector<double>* {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? nullptr : &rows.values[static_cast<std::size_t>(found - names.begin())];
  };
  const auto columns_of = [&](std::array<const char*, 3> parts) {
    return Columns{column(parts[0]), column(parts[1]), column(parts[2])};
  };
  const Columns first = columns_of({"x1", "y1", "z1"}), second = columns_of({"x2", "y2", "z2"});
  const Columns force = columns_of({"fx", "fy", "fz"}), more_force = columns_of({"ftx", "fty", "ftz"});
  const auto* const id1 = column("id1");
  const auto* const id2 = column("id2");
  const bool by_centre = whole(first) && whole(second);
  if (!((id1 && id2) || by_centre) || !whole(force)) {
    fail_at(source, frame.first_line - 1,
            "the columns id1 and id2 (or the centres x1 to z2), fx, fy and fz are needed; name them with "
            "--contact-columns");
  }
  PairForces pairs{source, frame.first_line, {}, {}, {}};
  for (std::size_t k = 0; k < frame.count; ++k) {
    if (id1 && id2) {
      pairs.ids.push_back({id_of((*id1)[k]), id_of((*id2)[k])});
    } else {
      pairs.centres.push_back({vector_of(first, k), vector_of(second, k)});
    }
    pairs.force.push_back(vector_of(force, k) + vector_of(more_force, k));
  }
  return pairs;
}

}  // namespace packstone::formats
