// SPDX-License-Identifier: MIT
#include "microslip/io/matrices/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "microslip/base/error.hpp"
#include "microslip/io/bytes/input_file.hpp"
#include "microslip/io/bytes/named_file.hpp"
#include "microslip/io/bytes/text.hpp"
#include "microslip/io/bytes/text_pieces.hpp"

namespace microslip {
namespace {

constexpr int kDeepestInclude = 16;
/// Longer lines are none of the format; the name goes into messages.
constexpr std::size_t kLongestInclude = 256;
/// CalculiX and Abaqus read no more of a number.
constexpr std::size_t kLongestNumber = 20;
/// That GENERATE and sets in sets put there: more than the nodes of any mesh that is taken.
constexpr std::size_t kMostInSets = kMostDegreesOfFreedom / 2;

/// The cells between commas; a comma at the end of the line begins none.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells = comma_cells(line);
  if (cells.back().empty()) cells.pop_back();
  return cells;
}

template <class Number>
std::optional<Number> number_of(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  return whole_number<Number>(text);
}

std::vector<std::int64_t> each_once(std::vector<std::int64_t> nodes) {
  std::ranges::sort(nodes);
  nodes.erase(std::ranges::unique(nodes).begin(), nodes.end());
  return nodes;
}

/// A coordinate as CalculiX and Abaqus read it: nothing is 0, D stands for the exponent as E does,
/// and blanks within count for nothing.
std::optional<double> coordinate_of(std::string_view cell) {
  std::string text;
  for (const char c : cell) {
    if (c != ' ' && c != '\t') text += c == 'D' || c == 'd' ? 'e' : c;
  }
  return text.empty() ? std::optional(0.0) : number_of<double>(text);
}

/// Keywords that make nodes or move them, where what stands in the file is not what is meant.
bool makes_nodes(std::string_view keyword) {
  constexpr std::array<std::string_view, 5> kKeywords{"*SYSTEM", "*NMAP", "*NCOPY", "*NGEN",
                                                      "*NFILL"};
  return std::ranges::find(kKeywords, keyword) != kKeywords.end();
}

[[noreturn]] void throw_not_global(const TextPlace& place, std::string_view found) {
  throw FormatError(place, "nodes in global coordinates", found,
                    "Give the nodes in a table: node [1], x [m], y [m], z [m].");
}

class InputReader {
 public:
  explicit InputReader(double length_unit) : length_unit_(length_unit) {}

  void read(std::string_view text, const std::string& file, int depth) {
    std::size_t number = 0;
    Section section;
    while (!text.empty()) {
      const std::string_view line = trimmed(take_dos_line(text));
      ++number;
      const TextPlace place{file, number, 0};
      if (line.empty() || line.starts_with("**")) continue;
      if (line.starts_with('*')) {
        section = open_section(line, place, depth);
      } else if (section.kind == Section::kNodes) {
        add_node(line, place, section.set);
      } else if (section.kind == Section::kSet) {
        add_to_set(line, place, section);
      } else if (section.kind == Section::kElements) {
        add_element(line);
      } else if (section.kind == Section::kConstraint) {
        add_constraint(line);
      } else if (section.kind == Section::kInstance) {
        throw_not_global(place, "an *INSTANCE that is moved");
      }
    }
  }

  MeshFile result() && {
    MeshFile mesh{.nodes = std::move(nodes_)};
    mesh.element_nodes = each_once(std::move(element_nodes_));
    mesh.rotation_nodes = each_once(std::move(rotation_nodes_));
    mesh.axisymmetric = axisymmetric_;
    mesh.beside_axisymmetric = beside_axisymmetric_;
    mesh.warnings = std::move(warnings_);
    for (const std::string& name : order_) {
      mesh.sets.push_back({name, each_once(std::move(sets_[name]))});
    }
    return mesh;
  }

 private:
  struct Section {
    enum Kind { kOther, kNodes, kSet, kInstance, kElements, kConstraint };
    Kind kind = kOther;
    std::string set;  ///< empty where nodes are in none
    bool generate = false;
  };

  Section open_section(std::string_view line, const TextPlace& place, int depth) {
    const std::vector<std::string_view> cells = cells_of(line);
    const std::string keyword = in_capitals(cells.front());
    Section section;
    std::string include;
    std::string type;
    std::string system = "R";
    for (std::size_t i = 1; i < cells.size(); ++i) {
      const std::size_t equals = cells[i].find('=');
      const std::string key = in_capitals(trimmed(cells[i].substr(0, equals)));
      const std::string_view value =
          equals == std::string_view::npos ? "" : trimmed(cells[i].substr(equals + 1));
      if (key == "NSET") section.set = in_capitals(value);
      if (key == "SYSTEM") system = in_capitals(value);
      if (key == "GENERATE") section.generate = true;
      if (key == "INPUT") include = value;
      if (key == "TYPE") type = in_capitals(value);
      if (key == "ROT NODE" && keyword == "*RIGID BODY") add_rotation_node(value);
    }
    if (keyword == "*ELEMENT") {
      section.kind = Section::kElements;
      begin_elements(type);
    }
    if (keyword == "*MPC") section.kind = Section::kConstraint;
    mean_rotation_ = false;
    if (keyword == "*NODE") section.kind = Section::kNodes;
    if (keyword == "*NSET") section.kind = Section::kSet;
    if (keyword == "*INSTANCE") section.kind = Section::kInstance;
    if (section.kind == Section::kSet && section.set.empty()) {
      throw FormatError(place, "*NSET, NSET=NAME", in_quotes(line));
    }
    if (keyword == "*INCLUDE") include_file(include, place, depth);
    if (makes_nodes(keyword)) throw_not_global(place, keyword);
    if (section.kind == Section::kNodes && system != "R") {
      throw FormatError(
          place, "nodes in x, y and z", in_quotes(line),
          "Give the nodes in a table: node [1], x [m], y [m], z [m]. CalculiX ignores "
          "SYSTEM: for its matrices remove it.");
    }
    const bool has_set = section.kind == Section::kNodes || section.kind == Section::kSet;
    if (has_set && !section.set.empty()) set_of(section.set);
    return section;
  }

  void include_file(const std::string& include, const TextPlace& place, int depth) {
    if (include.empty()) throw FormatError(place, "*INCLUDE, INPUT=FILE", "no file");
    if (include.size() > kLongestInclude) {
      throw FormatError(place, fmt::format("a name of at most {} bytes", kLongestInclude),
                        in_quotes(include));
    }
    if (depth == kDeepestInclude) {
      throw InputError(fmt::format("{}: INPUT", place_text(place)), in_quotes(include),
                       fmt::format("must not be the {}th file within another", depth + 1),
                       "Do files include each other?");
    }
    const std::string path = file_beside(place.file, include);
    read(read_text(path), path, depth + 1);
  }

  void begin_elements(const std::string& type) {
    (type.starts_with("CAX") ? axisymmetric_ : beside_axisymmetric_) = true;
    continued_ = false;
  }

  /// Its number, then its nodes; after a comma at the end they go on in the next line.
  void add_element(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line);
    for (std::size_t i = continued_ ? 0 : 1; i < cells.size(); ++i) {
      if (const auto node = number_of<std::int64_t>(cells[i])) element_nodes_.push_back(*node);
    }
    continued_ = line.ends_with(',');
  }

  void add_rotation_node(std::string_view cell) {
    if (const auto node = number_of<std::int64_t>(cell)) rotation_nodes_.push_back(*node);
  }

  /// The last node of a mean rotation turns; after 0 its list goes on.
  void add_constraint(std::string_view line) {
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.empty()) return;
    const bool goes_on = mean_rotation_ && cells.front() == "0";
    mean_rotation_ = goes_on || in_capitals(cells.front()) == "MEANROT";
    if (!mean_rotation_) return;
    if (goes_on) rotation_nodes_.pop_back();
    const auto node = number_of<std::int64_t>(cells.back());
    rotation_nodes_.push_back(node.value_or(0));
  }

  std::vector<std::int64_t>& set_of(const std::string& name) {
    const auto [found, is_new] = sets_.try_emplace(name);
    if (is_new) order_.push_back(name);
    return found->second;
  }

  static std::int64_t node_number(std::string_view cell, const TextPlace& place) {
    const std::optional<std::int64_t> number = number_of<std::int64_t>(cell);
    if (number && *number > 0) return *number;
    throw FormatError(place, "the number of a node", in_quotes(cell));
  }

  void add_node(std::string_view line, const TextPlace& place, const std::string& set) {
    const std::vector<std::string_view> cells = cells_of(line);
    MeshNode node{.number = node_number(cells.front(), place), .position = {}};
    for (std::size_t k = 0; k < 3 && k + 1 < cells.size(); ++k) {
      const std::string_view cell = cells[k + 1];
      const std::optional<double> value = coordinate_of(cell);
      if (!value || !std::isfinite(*value)) {
        throw FormatError(place, "a coordinate", in_quotes(cell));
      }
      if (cell.size() > kLongestNumber) warn_of_length(cell, place);
      node.position[k] = *value * length_unit_;
    }
    if (!set.empty()) set_of(set).push_back(node.number);
    const auto [known, is_new] = indices_.try_emplace(node.number, nodes_.size());
    if (is_new) {
      nodes_.push_back(node);
    } else {
      nodes_[known->second] = node;  // the last one counts, as in CalculiX
    }
  }

  /// Once per reading; the digits that are cut may be those of the exponent.
  void warn_of_length(std::string_view cell, const TextPlace& place) {
    const std::optional<double> cut = coordinate_of(cell.substr(0, kLongestNumber));
    if (!warnings_.empty() || (cut && *cut == *coordinate_of(cell))) return;
    warnings_.push_back(
        {"numbers_cut",
         fmt::format("{}: the coordinate {} has {} characters, of which CalculiX and Abaqus read "
                     "{}: {}. Their matrices are then of another body than these nodes. Write "
                     "shorter numbers and compute the matrices again",
                     place_text(place), in_quotes(cell), cell.size(), kLongestNumber,
                     cut ? fmt::format("{:.6g} instead of {:.6g}", *cut, *coordinate_of(cell))
                         : std::string("no number"))});
  }

  void add_to_set(std::string_view line, const TextPlace& place, const Section& section) {
    std::vector<std::int64_t>& set = set_of(section.set);
    const std::vector<std::string_view> cells = cells_of(line);
    if (section.generate) {
      generate(cells, place, set);
      return;
    }
    for (const std::string_view cell : cells) {
      if (const auto other = sets_.find(in_capitals(cell)); other != sets_.end()) {
        if (&other->second != &set) add_all(other->second, place, set);
      } else {
        set.push_back(node_number(cell, place));
      }
    }
  }

  /// The nodes of another set. Sets of sets grow by each of them.
  void add_all(const std::vector<std::int64_t>& nodes, const TextPlace& place,
               std::vector<std::int64_t>& set) {
    count(nodes.size(), place);
    set.insert(set.end(), nodes.begin(), nodes.end());
  }

  void count(std::size_t added, const TextPlace& place) {
    entries_ += added;
    if (entries_ <= kMostInSets) return;
    throw FormatError(place, fmt::format("up to {} nodes in all sets", kMostInSets),
                      fmt::format("{}", entries_));
  }

  void generate(const std::vector<std::string_view>& cells, const TextPlace& place,
                std::vector<std::int64_t>& set) {
    if (cells.size() < 2) throw FormatError(place, "the first and last node of GENERATE", "one");
    const std::int64_t first = node_number(cells[0], place);
    const std::int64_t last = node_number(cells[1], place);
    const std::int64_t step = cells.size() > 2 ? node_number(cells[2], place) : 1;
    if (last < first) {
      throw FormatError(place, "the first node before the last",
                        fmt::format("{} to {}", first, last));
    }
    const std::size_t nodes = static_cast<std::size_t>((last - first) / step) + 1;
    count(nodes, place);
    set.reserve(set.size() + nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
      set.push_back(first + static_cast<std::int64_t>(i) * step);
    }
  }

  double length_unit_;
  std::vector<MeshNode> nodes_;
  std::unordered_map<std::int64_t, std::size_t> indices_;  // of nodes, by number
  std::vector<Warning> warnings_;
  std::map<std::string, std::vector<std::int64_t>> sets_;
  std::vector<std::string> order_;
  std::vector<std::int64_t> element_nodes_;
  std::vector<std::int64_t> rotation_nodes_;
  bool axisymmetric_ = false;
  bool beside_axisymmetric_ = false;
  bool continued_ = false;      // an element
  bool mean_rotation_ = false;  // the constraint before
  std::size_t entries_ = 0;     // of sets, from ranges and other sets
};

}  // namespace

MeshFile parse_mesh_input(std::string_view text, const std::string& file, double length_unit) {
  InputReader reader(length_unit);
  reader.read(text, file, 0);
  return std::move(reader).result();
}

}  // namespace microslip
