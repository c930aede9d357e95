#include "core/formats/local_dump.hpp"

#include <algorithm>
#include <array>
#include <cmath>
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
constexpr int most_walls = 10000;

/// What the columns of a kind of file can be.
struct Meaning {
  std::vector<std::string> names;
  std::map<std::size_t, const char*> usual;  ///< by number of columns where the file has no names
  const char* option;                        ///< that names them
};

/// LIGGGHTS writes the keywords of compute pair/gran/local in a fixed order; 5 columns are the least one can do with.
const Meaning of_pairs = {
    {"id1", "id2", "x1", "y1", "z1", "x2", "y2", "z2", "fx", "fy", "fz", "ftx", "fty", "ftz", "-"},
    {{5, "id1 id2 fx fy fz"},
     {6, "id1 id2 - fx fy fz"},
     {9, "x1 y1 z1 x2 y2 z2 fx fy fz"},
     {12, "x1 y1 z1 x2 y2 z2 id1 id2 - fx fy fz"}},
    "--contact-columns"};

const Meaning of_walls = {{"px", "py", "pz", "x", "y", "z", "wall", "id", "fx", "fy", "fz", "ftx", "fty", "ftz", "-"},
                          {{9, "px py pz x y z fx fy fz"}, {12, "px py pz x y z wall - id fx fy fz"}},
                          "--wall-columns"};

std::vector<std::string> usual(const Meaning& meaning, std::size_t count) {
  std::vector<std::string> names;
  const auto found = meaning.usual.find(count);
  if (found == meaning.usual.end()) return names;
  for (const std::string_view name : words(found->second)) names.emplace_back(name);
  return names;
}

std::vector<std::string> named_columns(const DumpFrame& frame, const std::string& source, const Meaning& meaning,
                                       const std::vector<std::string>& given) {
  const auto is_known = [&](const std::string& name) {
    return std::find(meaning.names.begin(), meaning.names.end(), name) != meaning.names.end();
  };
  std::vector<std::string> names = given;
  if (names.empty() && std::any_of(frame.columns.begin(), frame.columns.end(), is_known)) {
    for (const std::string& name : frame.columns) names.push_back(is_known(name) ? name : "-");
  }
  if (names.empty()) names = usual(meaning, frame.columns.size());
  const std::int64_t head = frame.first_line - 1;
  if (names.empty()) {
    fail_at(source, head,
            fmt::format("the {} columns do not say what they are; name them with {}, out of {}", frame.columns.size(),
                        meaning.option, joined(meaning.names)));
  }
  if (names.size() != frame.columns.size()) {
    fail_at(source, head,
            fmt::format("the file has {} columns, {} names {}; they must agree (- for one that is not used)",
                        frame.columns.size(), meaning.option, names.size()));
  }
  for (const std::string& name : names) {
    if (!is_known(name)) {
      fail_at(source, head, fmt::format("\"{}\" is no column of contacts; there are: {}", name, joined(meaning.names)));
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

/// Three columns that are a vector's components; null where the file does not have one.
using VectorColumns = std::array<const std::vector<double>*, 3>;

bool whole(const VectorColumns& columns) { return columns[0] && columns[1] && columns[2]; }

/// Components that the file does not have are 0.
Vec3 vector_of(const VectorColumns& columns, std::size_t row) {
  Vec3 value = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    if (columns[axis]) value[axis] = (*columns[axis])[row];
  }
  return value;
}

/// -1, which no particle has, for what is no id.
std::int64_t id_of(double value) { return value >= 0 && value < largest_id ? static_cast<std::int64_t>(value) : -1; }

/// The rows of one frame by their columns' meaning.
class ContactRows {
 public:
  ContactRows(const std::filesystem::path& path, std::int64_t step, const Meaning& meaning,
              const std::vector<std::string>& given)
      : source_(path.string()), meaning_(meaning) {
    const MappedFile file(path);
    if (!is_lammps_dump(file.text())) throw InputError(source_ + ": is no dump of contacts; it would begin with ITEM:");
    const std::vector<DumpFrame> frames = index_dump(file.text(), source_);
    const DumpFrame& frame = frame_of_step(frames, source_, step);
    names_ = named_columns(frame, source_, meaning, given);
    first_line_ = frame.first_line;
    count_ = frame.count;
    std::vector<RowColumn> wanted;
    for (const auto& name : names_) {
      wanted.push_back({name, name == "-" ? RowColumn::Kind::skipped : RowColumn::Kind::number});
    }
    rows_ = read_rows({file.text().substr(frame.first_byte), source_, first_line_}, count_, wanted);
  }

  const std::string& source() const { return source_; }
  std::int64_t first_line() const { return first_line_; }
  std::size_t count() const { return count_; }

  /// Null where the file does not have it.
  const std::vector<double>* column(const std::string& name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? nullptr : &rows_.values[static_cast<std::size_t>(found - names_.begin())];
  }
  VectorColumns vectors(const std::array<const char*, 3>& parts) const {
    return {column(parts[0]), column(parts[1]), column(parts[2])};
  }
  Vec3 force(std::size_t row) const {
    return vector_of(vectors({"fx", "fy", "fz"}), row) + vector_of(vectors({"ftx", "fty", "ftz"}), row);
  }
  void require(bool present, const char* what) const {
    if (present && whole(vectors({"fx", "fy", "fz"}))) return;
    fail_at(source_, first_line_ - 1,
            fmt::format("the columns {}, fx, fy and fz are needed; name them with {}", what, meaning_.option));
  }

 private:
  std::string source_;
  const Meaning& meaning_;
  std::vector<std::string> names_;
  std::int64_t first_line_ = 0;
  std::size_t count_ = 0;
  Rows rows_;
};

}  // namespace

PairForces read_local_dump(const std::filesystem::path& path, std::int64_t step,
                           const std::vector<std::string>& column_names) {
  const ContactRows rows(path, step, of_pairs, column_names);
  const VectorColumns first = rows.vectors({"x1", "y1", "z1"}), second = rows.vectors({"x2", "y2", "z2"});
  const auto* const id1 = rows.column("id1");
  const auto* const id2 = rows.column("id2");
  rows.require((id1 && id2) || (whole(first) && whole(second)), "id1 and id2 (or the centres x1 to z2)");
  PairForces pairs{rows.source(), rows.first_line(), {}, {}, {}};
  for (std::size_t k = 0; k < rows.count(); ++k) {
    if (id1 && id2) {
      pairs.ids.push_back({id_of((*id1)[k]), id_of((*id2)[k])});
    } else {
      pairs.centres.push_back({vector_of(first, k), vector_of(second, k)});
    }
    pairs.force.push_back(rows.force(k));
  }
  return pairs;
}

WallForces read_wall_dump(const std::filesystem::path& path, std::int64_t step,
                          const std::vector<std::string>& column_names) {
  const ContactRows rows(path, step, of_walls, column_names);
  const VectorColumns point = rows.vectors({"px", "py", "pz"}), centre = rows.vectors({"x", "y", "z"});
  const auto* const id = rows.column("id");
  const auto* const wall = rows.column("wall");
  rows.require(whole(point) && (id || whole(centre)), "px, py, pz, id (or the centre x, y, z)");
  WallForces walls{rows.source(), rows.first_line(), {}, {}, {}, {}, {}};
  for (std::size_t k = 0; k < rows.count(); ++k) {
    const double number = wall ? (*wall)[k] : 0;
    if (!(number >= 0 && number < most_walls && std::trunc(number) == number)) {
      fail_at(rows.source(), rows.first_line() + static_cast<std::int64_t>(k),
              fmt::format("wall: {:g} is no number of a wall; they go from 0 to {}", number, most_walls - 1));
    }
    walls.wall.push_back(static_cast<std::int32_t>(number));
    if (id) {
      walls.id.push_back(id_of((*id)[k]));
    } else {
      walls.centre.push_back(vector_of(centre, k));
    }
    walls.point.push_back(vector_of(point, k));
    walls.force.push_back(rows.force(k));
  }
  return walls;
}

}  // namespace packstone::formats
