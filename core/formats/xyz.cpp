#include "core/formats/xyz.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text_lines.hpp"

namespace packstone::formats {

namespace {

struct Property {
  const char* name;
  std::vector<const char*> columns;
};

/// Properties with names of their own here; of others, components are numbered.
const std::vector<Property> known_properties = {
    {"pos", {"x", "y", "z"}},         {"velo", {"vx", "vy", "vz"}},       {"vel", {"vx", "vy", "vz"}},
    {"velocity", {"vx", "vy", "vz"}}, {"velocities", {"vx", "vy", "vz"}}, {"angular_velocity", {"wx", "wy", "wz"}},
    {"omega", {"wx", "wy", "wz"}},    {"force", {"fx", "fy", "fz"}},      {"forces", {"fx", "fy", "fz"}}};

const char* const properties_example = "Properties=species:S:1:pos:R:3:radius:R:1";
constexpr std::size_t most_components = 100;  ///< of a property

/// key=value and key="value with spaces" of the comment line, keys in lower case.
std::map<std::string, std::string, std::less<>> key_values(std::string_view line) {
  std::map<std::string, std::string, std::less<>> result;
  while (true) {
    line = trimmed(line);
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) return result;
    const auto before = words(line.substr(0, equals));
    std::string key(before.empty() ? std::string_view() : before.back());
    std::transform(key.begin(), key.end(), key.begin(), [](unsigned char c) { return std::tolower(c); });
    line.remove_prefix(equals + 1);
    const bool quoted = line.starts_with('"');
    if (quoted) line.remove_prefix(1);
    const std::size_t end = std::min(quoted ? line.find('"') : line.find_first_of(" \t"), line.size());
    result.emplace(key, std::string(line.substr(0, end)));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
}

class XyzIndex {
 public:
  XyzIndex(std::string_view text, const std::string& source) : text_(text), cursor_({text, source}) {}

  std::vector<XyzFrame> read() {
    std::vector<XyzFrame> frames;
    while (!cursor_.at_end()) {
      const std::string_view line = cursor_.next("the number of particles");
      if (line.empty() && !frames.empty()) continue;  // blank lines at the end
      frames.push_back(read_frame(line));
    }
    return frames;
  }

 private:
  XyzFrame read_frame(std::string_view first) {
    XyzFrame frame;
    const auto count = parsed_integer(first);
    if (!count || *count < 0) {
      cursor_.fail(fmt::format("\"{:.40}\" stands where the number of particles is expected", first));
    }
    frame.count = static_cast<std::size_t>(*count);
    keys_ = key_values(cursor_.next("the line that describes the columns"));
    read_properties(frame);
    read_box(frame);
    if (const auto* time = value("time")) frame.time = number("Time", *time);
    for (const char* key : {"step", "timestep"}) {
      if (const auto* step = value(key)) frame.step = parsed_integer(*step).value_or(0);
    }
    const TextPart rows = cursor_.rest();
    frame.first_byte = text_.size() - rows.text.size();
    frame.first_line = rows.first_line;
    cursor_.skip(frame.count, "rows");
    return frame;
  }

  const std::string* value(std::string_view key) const {
    const auto found = keys_.find(key);
    return found == keys_.end() ? nullptr : &found->second;
  }

  double number(const char* what, std::string_view field) const {
    const auto parsed = parsed_number(field);
    if (!parsed || !std::isfinite(*parsed)) cursor_.fail(number_complaint(what, field));
    return *parsed;
  }

  void read_properties(XyzFrame& frame) const {
    const std::string* text = value("properties");
    if (!text) {
      cursor_.fail(
          fmt::format("plain XYZ has no radii; extended XYZ is read, with {} in this line", properties_example));
    }
    const auto parts = split(*text, ':');
    if (parts.size() % 3 != 0) {
      cursor_.fail(
          fmt::format("Properties: {} is not made of name:kind:count; expected such as {}", *text, properties_example));
    }
    for (std::size_t k = 0; k < parts.size(); k += 3) {
      const auto count = parsed_integer(parts[k + 2]);
      if (!count || *count < 1 || *count > static_cast<std::int64_t>(most_components)) {
        cursor_.fail(fmt::format("Properties: {} has \"{}\" components; expected 1 to {}", parts[k], parts[k + 2],
                                 most_components));
      }
      add_property(frame, std::string(parts[k]), parts[k + 1], static_cast<std::size_t>(*count));
    }
  }

  static void add_property(XyzFrame& frame, const std::string& name, std::string_view kind, std::size_t count) {
    const bool numbers = kind == "R" || kind == "I";
    const bool names_types = name == "species" || name == "element";
    const auto found = std::find_if(known_properties.begin(), known_properties.end(),
                                    [&](const Property& p) { return p.name == name && p.columns.size() == count; });
    for (std::size_t c = 0; c < count; ++c) {
      std::string column = count == 1 ? name : fmt::format("{}_{}", name, c + 1);
      if (found != known_properties.end()) column = found->columns[c];
      const auto kind_here = numbers       ? RowColumn::Kind::number
                             : names_types ? RowColumn::Kind::word
                                           : RowColumn::Kind::skipped;
      frame.columns.push_back({column, kind_here});
    }
  }

  Vec3 three_numbers(const char* key) const {
    Vec3 result = Vec3::Zero();
    const std::string* text = value(key);
    if (!text) return result;
    const auto parts = words(*text);
    if (parts.size() != 3) cursor_.fail(fmt::format("{}: {} numbers; expected 3", key, parts.size()));
    for (int k = 0; k < 3; ++k) result[k] = number(key, parts[k]);
    return result;
  }

  void read_box(XyzFrame& frame) const {
    const std::string* text = value("lattice");
    if (!text) return;
    const auto parts = words(*text);
    if (parts.size() != 9) cursor_.fail(fmt::format("Lattice: {} numbers; expected 9", parts.size()));
    Domain box;
    box.min = three_numbers("origin");
    const std::string* flags = value("pbc");
    const auto periodic = flags ? words(*flags) : std::vector<std::string_view>(3, "T");  // as the format says
    if (periodic.size() != 3) cursor_.fail("pbc: expected three of T and F");
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double entry = number("Lattice", parts[3 * row + k]);
        if (row != k && entry != 0) cursor_.fail("Lattice: the box is not along the axes; only such boxes are read");
        if (row == k && !(entry > 0)) cursor_.fail(fmt::format("Lattice: a side of {} m; it must be above 0", entry));
        if (row == k) box.max[static_cast<int>(k)] = box.min[static_cast<int>(k)] + entry;
      }
      box.periodic[row] = periodic[row] == "T" || periodic[row] == "1" || periodic[row] == "True";
    }
    frame.box = box;
  }

  std::string_view text_;
  LineCursor cursor_;
  std::map<std::string, std::string, std::less<>> keys_;
};

/// Species name the types; beside numbers of types, each number has the species of its last particle.
void set_types(ParticleColumns& columns, std::vector<double>&& species, const std::vector<std::string>& words) {
  const auto found = columns.values.find("type");
  if (found == columns.values.end()) {
    columns.type_names = words;
    columns.values.emplace("type", std::move(species));
    return;
  }
  for (std::size_t i = 0; i < species.size(); ++i) {
    const double type = found->second[i];
    constexpr double most_names = 10000;
    if (!(type >= 0 && type < most_names)) continue;  // refused when the particles are checked
    const auto index = static_cast<std::size_t>(type);
    for (std::size_t k = columns.type_names.size(); k <= index; ++k)
      columns.type_names.push_back(fmt::format("type {}", k));
    columns.type_names[index] = words[static_cast<std::size_t>(species[i])];
  }
}

}  // namespace

bool is_xyz(std::string_view text) {
  const auto first = trimmed(text.substr(0, text.find('\n')));
  return !first.empty() && std::all_of(first.begin(), first.end(), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<XyzFrame> index_xyz(std::string_view text, const std::string& source) {
  return XyzIndex(text, source).read();
}

ParticleColumns read_xyz_frame(std::string_view text, const std::string& source, const XyzFrame& frame) {
  if (frame.first_byte > text.size()) throw InputError(source + ": has become shorter while it was read");
  Rows rows = read_rows({text.substr(frame.first_byte), source, frame.first_line}, frame.count, frame.columns);
  ParticleColumns columns;
  columns.source = source;
  columns.count = frame.count;
  columns.first_line = frame.first_line;
  columns.domain = frame.box;
  columns.time = frame.time.value_or(0);
  columns.step = frame.step;
  std::size_t species = frame.columns.size();
  for (std::size_t k = 0; k < frame.columns.size(); ++k) {
    const RowColumn& column = frame.columns[k];
    if (column.kind == RowColumn::Kind::number) add_column(columns, column.name, std::move(rows.values[k]));
    if (column.kind == RowColumn::Kind::word) species = k;
  }
  if (species < frame.columns.size()) set_types(columns, std::move(rows.values[species]), rows.words[species]);
  return columns;
}

void write_xyz(TextOutput& out, const Snapshot& s) {
  const Vec3 size = s.domain.size();
  const auto flag = [&](int k) { return s.domain.periodic[k] ? "T" : "F"; };
  const bool with_mass = s.size() > 0 && s.has_masses();
  const auto extra = vector_columns(s, {"vx", "vy", "vz"}, {"wx", "wy", "wz"});
  out.print("{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} {} {}\" Time={} Step={} ", s.size(),
            size.x(), size.y(), size.z(), s.domain.min.x(), s.domain.min.y(), s.domain.min.z(), flag(0), flag(1),
            flag(2), s.time, s.step);
  out.print("Properties=species:S:1:id:I:1:type:I:1:pos:R:3:radius:R:1{}", with_mass ? ":mass:R:1" : "");
  for (std::size_t k = 0; k < extra.size(); k += 3) {
    const bool spin = extra[k].name == "wx", push = extra[k].name == "fx";
    out.print(":{}:R:3", spin ? "angular_velocity" : push ? "force" : "velo");
  }
  std::vector<std::string> species;
  for (const auto& group : s.groups) {
    std::string name = group.name.empty() ? "X" : group.name;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isspace(c); }, '_');
    species.push_back(name);
  }
  for (std::size_t i = 0; i < s.size(); ++i) {
    const Vec3& p = s.position[i];
    out.print("\n{} {} {} {} {} {} {}", species[static_cast<std::size_t>(s.type[i])], s.id[i], s.type[i], p.x(), p.y(),
              p.z(), s.radius[i]);
    if (with_mass) out.print(" {}", mass_of(s, i));
    for (const auto& column : extra) out.print(" {}", column.value(i));
  }
  out.print("\n");
}

}  // namespace packstone::formats
