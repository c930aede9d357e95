#include "core/formats/lammps_dump.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

constexpr std::string_view item = "ITEM:";
/// Columns that are words: kinds of atoms, which name the types.
constexpr std::array word_columns = {"element", "typelabel"};
/// How often a particle has left through a periodic side: positions inside the box are read without it.
constexpr std::array skipped_columns = {"ix", "iy", "iz"};

class DumpIndex {
 public:
  DumpIndex(std::string_view text, const std::string& source) : text_(text), cursor_({text, source}) {}

  std::vector<DumpFrame> read() {
    std::vector<DumpFrame> frames;
    while (next_item()) {
      if (item_is("UNITS")) {
        read_units();
      } else if (item_is("TIME")) {
        frame_.time = number(cursor_.next("the time"), "TIME");
      } else if (item_is("TIMESTEP")) {
        frame_.step = integer(cursor_.next("the number of the time step"), "TIMESTEP");
      } else if (item_is("NUMBER OF ATOMS") || item_is("NUMBER OF ENTRIES")) {
        read_count();
      } else if (item_.starts_with("BOX BOUNDS")) {
        read_box();
      } else if (item_.starts_with("ATOMS") || item_.starts_with("ENTRIES")) {
        frames.push_back(finish_frame());
      } else {
        cursor_.fail(
            fmt::format("\"{}\" is unknown; expected one of TIMESTEP, NUMBER OF ATOMS, BOX BOUNDS, ATOMS", item_));
      }
    }
    if (frames.empty() || counted_) cursor_.fail("the file ends in a frame's head; is it cut short?");
    return frames;
  }

 private:
  /// Moves to the next ITEM, over blank lines; false at the end of the file.
  bool next_item() {
    std::string_view line;
    while (line.empty()) {
      if (cursor_.at_end()) return false;
      line = cursor_.next("an ITEM");
    }
    if (!line.starts_with(item)) {
      cursor_.fail(fmt::format("\"{:.40}\" stands where an ITEM is expected; is the number of rows right?", line));
    }
    item_ = trimmed(line.substr(item.size()));
    return true;
  }

  bool item_is(std::string_view name) const { return item_ == name; }

  double number(std::string_view field, const char* what) const {
    const auto value = parsed_number(field);
    if (!value || !std::isfinite(*value)) cursor_.fail(number_complaint(what, field));
    return *value;
  }

  std::int64_t integer(std::string_view field, const char* what) const {
    const auto value = parsed_integer(field);
    if (!value) cursor_.fail(fmt::format("{}: \"{}\" is not a whole number", what, field));
    return *value;
  }

  void read_units() {
    const std::string_view units = cursor_.next("the units");
    if (units != "si") cursor_.fail(fmt::format("the file is in units {}; only units si is read", units));
  }

  void read_count() {
    const std::int64_t count = integer(cursor_.next("the number of rows"), "NUMBER");
    if (count < 0) cursor_.fail(fmt::format("{} rows; the number must be 0 or above", count));
    frame_.count = static_cast<std::size_t>(count);
    counted_ = true;
  }

  /// "pp pp ff" after the words BOX BOUNDS; older versions leave it out.
  void read_box() {
    const std::vector<std::string_view> flags = words(item_.substr(std::string_view("BOX BOUNDS").size()));
    const bool tilted = !flags.empty() && (flags.front() == "xy" || flags.front() == "abc");
    if (tilted || flags.size() > 3) cursor_.fail("the box is triclinic; only boxes along the axes are read");
    for (int k = 0; k < 3; ++k) {
      const auto bounds = words(cursor_.next("the box's bounds along " + std::string(axis_names[k])));
      if (bounds.size() != 2) {
        cursor_.fail(fmt::format("{} numbers bound the box along {}; expected 2 (a triclinic box is not read)",
                                 bounds.size(), axis_names[k]));
      }
      frame_.box.min[k] = number(bounds[0], "lower bound");
      frame_.box.max[k] = number(bounds[1], "upper bound");
      if (!(frame_.box.min[k] < frame_.box.max[k])) {
        cursor_.fail(fmt::format("the box along {} goes from {} to {}; the lower bound must be below the upper",
                                 axis_names[k], bounds[0], bounds[1]));
      }
      frame_.box.periodic[k] = flags.size() == 3 && flags[k] == "pp";
    }
    bounded_ = true;
  }

  DumpFrame finish_frame() {
    if (!counted_) cursor_.fail("the frame does not say its NUMBER OF ATOMS");
    if (!bounded_) cursor_.fail("the frame has no BOX BOUNDS");
    const std::vector<std::string_view> names = words(item_);
    frame_.local = names.front() == "ENTRIES";
    frame_.columns.assign(names.begin() + 1, names.end());
    if (frame_.columns.empty())
      cursor_.fail("the columns have no names; they stand behind ITEM: " + std::string(names[0]));
    const TextPart rows = cursor_.rest();
    frame_.first_byte = text_.size() - rows.text.size();
    frame_.first_line = rows.first_line;
    cursor_.skip(frame_.count, "rows");
    const DumpFrame done = frame_;
    frame_ = {};
    counted_ = bounded_ = false;
    return done;
  }

  std::string_view text_;
  LineCursor cursor_;
  std::string_view item_;
  DumpFrame frame_;
  bool counted_ = false, bounded_ = false;
};

RowColumn row_column(const std::string& name) {
  const auto is_one_of = [&](const auto& names) { return std::find(names.begin(), names.end(), name) != names.end(); };
  if (is_one_of(skipped_columns)) return {name, RowColumn::Kind::skipped};
  return {name, is_one_of(word_columns) ? RowColumn::Kind::word : RowColumn::Kind::number};
}

/// Positions by whichever of x, xu, xs, xsu the file has along each axis.
void add_positions(ParticleColumns& columns, const Domain& box) {
  for (int k = 0; k < 3; ++k) {
    const std::string axis = axis_names[k];
    for (const std::string_view suffix : {"", "u", "s", "su"}) {
      const auto found = columns.values.find(axis + std::string(suffix));
      if (found == columns.values.end()) continue;
      std::vector<double> values = std::move(found->second);
      columns.values.erase(found);
      if (suffix.starts_with("s")) {
        for (double& value : values) value = box.min[k] + value * (box.max[k] - box.min[k]);
      }
      columns.values.emplace(axis, std::move(values));
    }
  }
}

}  // namespace

bool is_lammps_dump(std::string_view text) { return text.starts_with(item); }

std::vector<DumpFrame> index_dump(std::string_view text, const std::string& source) {
  return DumpIndex(text, source).read();
}

ParticleColumns read_dump_frame(std::string_view text, const std::string& source, const DumpFrame& frame) {
  if (frame.local) {
    fail_at(source, frame.first_line - 1,
            "the file holds contacts (ITEM: ENTRIES), not particles; name the particles' dump, and this one with "
            "convert --contacts");
  }
  if (frame.first_byte > text.size()) throw InputError(source + ": has become shorter while it was read");
  std::vector<RowColumn> wanted;
  for (const std::string& name : frame.columns) wanted.push_back(row_column(name));
  Rows rows = read_rows({text.substr(frame.first_byte), source, frame.first_line}, frame.count, wanted);

  ParticleColumns columns;
  columns.source = source;
  columns.count = frame.count;
  columns.first_line = frame.first_line;
  columns.first_type = 1;
  columns.domain = frame.box;
  columns.step = frame.step;
  columns.time = frame.time.value_or(0);
  std::size_t types = wanted.size();
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    if (wanted[k].kind == RowColumn::Kind::number) add_column(columns, wanted[k].name, std::move(rows.values[k]));
    if (wanted[k].kind == RowColumn::Kind::word) types = k;
  }
  if (types < wanted.size() && !columns.has("type")) {
    columns.first_type = 0;
    columns.type_names = rows.words[types];
    columns.values.emplace("type", std::move(rows.values[types]));
  }
  add_positions(columns, frame.box);
  return columns;
}

void write_lammps_dump(TextOutput& out, const Snapshot& s) {
  out.print("ITEM: UNITS\nsi\nITEM: TIME\n{}\nITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n{}\nITEM: BOX BOUNDS", s.time,
            s.step, s.size());
  for (int k = 0; k < 3; ++k) out.print(" {}", s.domain.periodic[k] ? "pp" : "ff");
  for (int k = 0; k < 3; ++k) out.print("\n{} {}", s.domain.min[k], s.domain.max[k]);
  const std::vector<OutputColumn> extra = vector_columns(s, {"vx", "vy", "vz"}, {"omegax", "omegay", "omegaz"});
  const bool with_mass = s.has_masses();
  out.print("\nITEM: ATOMS id type x y z radius{}", with_mass ? " mass" : "");
  for (const auto& column : extra) out.print(" {}", column.name);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3& p = s.position[i];
    out.print("\n{} {} {} {} {} {}", s.id[i], s.type[i] + 1, p.x(), p.y(), p.z(), s.radius[i]);
    if (with_mass) out.print(" {}", mass_of(s, i));
    for (const auto& column : extra) out.print(" {}", column.value(i));
  }
  out.print("\n");
}

}  // namespace packstone::formats
