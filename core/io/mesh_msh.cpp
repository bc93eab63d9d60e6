// Gmsh's MSH files, versions 2 and 4.1, text and binary ("MSH file format" in Gmsh's manual):
// triangles and quadrangles, with their physical groups. Nodes are vertices in the file's order.
#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/msh_numbers.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg {
namespace {

/// An element type: its number in the format, the number of its nodes, its dimension, and the
/// number of corners of a face. The corners come first among the nodes of a face.
struct ElementType {
  std::size_t number, nodes, dimension, corners;
};

constexpr std::array<ElementType, 45> kTypes{
    {{1, 2, 1, 0},   {2, 3, 2, 3},   {3, 4, 2, 4},   {4, 4, 3, 0},   {5, 8, 3, 0},   {6, 6, 3, 0},
     {7, 5, 3, 0},   {8, 3, 1, 0},   {9, 6, 2, 3},   {10, 9, 2, 4},  {11, 10, 3, 0}, {12, 27, 3, 0},
     {13, 18, 3, 0}, {14, 14, 3, 0}, {15, 1, 0, 0},  {16, 8, 2, 4},  {17, 20, 3, 0}, {18, 15, 3, 0},
     {19, 13, 3, 0}, {20, 9, 2, 3},  {21, 10, 2, 3}, {22, 12, 2, 3}, {23, 15, 2, 3}, {24, 15, 2, 3},
     {25, 21, 2, 3}, {26, 4, 1, 0},  {27, 5, 1, 0},  {28, 6, 1, 0},  {29, 20, 3, 0}, {30, 35, 3, 0},
     {31, 56, 3, 0}, {36, 16, 2, 4}, {37, 25, 2, 4}, {38, 36, 2, 4}, {39, 12, 2, 4}, {40, 16, 2, 4},
     {41, 20, 2, 4}, {42, 28, 2, 3}, {43, 36, 2, 3}, {44, 45, 2, 3}, {45, 55, 2, 3}, {46, 66, 2, 3},
     {47, 49, 2, 4}, {92, 64, 3, 0}, {93, 125, 3, 0}}};

/// Maps the numbers of nodes, which are arbitrary, to vertices.
class NodeNumbers {
 public:
  void add(std::int64_t tag) {
    consecutive_ = consecutive_ && (all_.empty() || tag == all_.back().first + 1);
    all_.emplace_back(tag, static_cast<std::uint32_t>(all_.size()));
  }
  /// Must be called before vertex(). Returns a number that two nodes have, if any.
  std::optional<std::int64_t> finish() {
    if (consecutive_) return std::nullopt;
    std::sort(all_.begin(), all_.end());
    const auto twice = std::adjacent_find(
        all_.begin(), all_.end(), [](const Node& a, const Node& b) { return a.first == b.first; });
    if (twice != all_.end()) return twice->first;
    return std::nullopt;
  }
  [[nodiscard]] std::optional<std::uint32_t> vertex(std::int64_t tag) const {
    if (all_.empty() || tag < all_.front().first || tag > all_.back().first) return std::nullopt;
    if (consecutive_) return all_[static_cast<std::size_t>(tag - all_.front().first)].second;
    const auto found = std::lower_bound(all_.begin(), all_.end(), Node{tag, 0});
    if (found == all_.end() || found->first != tag) return std::nullopt;
    return found->second;
  }

 private:
  using Node = std::pair<std::int64_t, std::uint32_t>;  // number, vertex
  std::vector<Node> all_;
  bool consecutive_ = true;
};

class MshReader {
 public:
  MshReader(const MeshFile& file, MeshAttributes* attributes)
      : file_(file), numbers_(file), attributes_(attributes) {}

  MeshLists read() {
    for (std::string_view word = scanner().word(); !word.empty(); word = scanner().word()) {
      if (word.front() != '$')
        numbers_.fail("expected a section such as $Nodes, found '" + printable(word) + "'");
      read_section(std::string(word.substr(1)));
    }
    if (version_ == 0) bad_file(file_.path, "it has no section $MeshFormat.");
    if (lists_.triangles.empty() && !lists_.points.empty()) {
      bad_file(file_.path,
               volumes_ > 0
                   ? "it has volumes but no triangles or quadrangles; save its surface, too "
                     "(in Gmsh: a physical group of surfaces, or Mesh.SaveAll)."
                   : "it has no triangles or quadrangles, so it holds no surface.");
    }
    tell();
    if (attributes_ != nullptr) add_attributes();
    return std::move(lists_);
  }

 private:
  formats::WordScanner& scanner() { return numbers_.scanner(); }

  void read_section(const std::string& name) {
    if (name == "MeshFormat") {
      read_format();
    } else if (version_ == 0) {
      numbers_.fail("expected $MeshFormat before all other sections");
    } else if (name == "PhysicalNames") {
      read_names();
    } else if (name == "Entities" && version_ == 4) {
      begin_bytes();
      read_entities();
    } else if (name == "Nodes") {
      if (!lists_.points.empty()) numbers_.fail("$Nodes comes twice");
      version_ == 4 ? read_nodes4() : read_nodes2();
    } else if (name == "Elements") {
      version_ == 4 ? read_elements4() : read_elements2();
    } else {
      skip_section(name);
    }
    const std::string_view end = scanner().word();
    if (end != "$End" + name) scanner().fail("$End" + name, end);
  }

  void begin_bytes() {
    if (numbers_.is_binary()) scanner().next_line();
  }

  void skip_section(const std::string& name) {
    const std::size_t at = file_.bytes.find("$End" + name, scanner().position());
    if (at == std::string_view::npos) numbers_.fail("the file ends in $" + printable(name));
    scanner().skip_to(at);
  }

  void read_format() {
    const std::string_view version = scanner().word();
    if (version == "4.1") version_ = 4;
    if (version == "2" || version == "2.0" || version == "2.1" || version == "2.2") version_ = 2;
    if (version_ == 0) {
      numbers_.fail("version '" + printable(version) +
                    "' is not read; save it as version 4.1 or 2.2 (gmsh -save -format msh41)");
    }
    const std::int64_t binary = numbers_.whole("0 (text) or 1 (binary)");
    const std::int64_t size = numbers_.whole("the size of a number");
    if (binary == 0) return;
    if (size != 8 && (version_ == 2 || size != 4)) numbers_.fail("expected numbers of 8 bytes");
    scanner().next_line();
    numbers_.set_binary(false, version_ == 4 ? static_cast<std::size_t>(size) : 4);
    const std::int64_t one = numbers_.whole("the number one");
    if (one == 1) return;
    if (one != 0x01000000) numbers_.fail("expected the number one, which tells the order of bytes");
    numbers_.set_swap(true);
  }

  /// Reads the names of physical groups, which are text in binary files, too.
  void read_names() {
    const std::int64_t n = scanner().integer(scanner().word(), "the number of names");
    for (std::int64_t k = 0; k < n; ++k) {
      const std::int64_t dimension = scanner().integer(scanner().word(), "a dimension");
      const std::int64_t tag = scanner().integer(scanner().word(), "the number of a group");
      std::string_view rest = scanner().rest_of_line();
      rest = rest.substr(std::min(rest.find('"'), rest.size()));
      const std::size_t end = rest.rfind('"');
      if (end == std::string_view::npos || end == 0) numbers_.fail("expected a name in quotes");
      if (dimension == 2) names_[tag] = printable(rest.substr(1, end - 1));
      scanner().next_line();
    }
  }

  /// Reads the physical group of each surface; the first group if a surface has several.
  void read_entities() {
    std::array<std::size_t, 4> counts{};
    for (std::size_t& n : counts) n = numbers_.count(numbers_.large("a count"), "entities", 20);
    for (std::size_t d = 0; d < 4; ++d) {
      for (std::size_t k = 0; k < counts[d]; ++k) read_entity(d);
    }
  }

  void read_entity(std::size_t dimension) {
    const std::int64_t tag = numbers_.whole("the number of an entity");
    for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) numbers_.real("a bound of an entity");
    const std::size_t groups =
        numbers_.count(numbers_.large("the number of groups"), "physical groups", 4);
    for (std::size_t k = 0; k < groups; ++k) {
      const std::int64_t group = numbers_.whole("the number of a group");
      if (dimension == 2) group_of_.emplace(tag, group);
    }
    if (dimension == 0) return;
    const std::size_t bounds =
        numbers_.count(numbers_.large("the number of boundaries"), "boundaries", 4);
    for (std::size_t k = 0; k < bounds; ++k) numbers_.whole("the number of an entity");
  }

  void add_node(std::int64_t tag, const Point& p) {
    nodes_.add(tag);
    lists_.points.push_back(p);
  }

  Point read_point() {
    Point p;
    for (double& x : p) x = numbers_.real("a coordinate");
    return p;
  }

  void read_nodes2() {
    const std::int64_t announced = scanner().integer(scanner().word(), "the number of nodes");
    begin_bytes();
    const std::size_t n = numbers_.count(announced, "nodes", 28);
    lists_.points.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
      const std::int64_t tag = numbers_.whole("the number of a node");
      add_node(tag, read_point());
    }
    end_nodes();
  }

  void end_nodes() {
    const auto twice = nodes_.finish();
    if (twice) numbers_.fail(fmt::format("node {} comes twice", *twice));
  }

  void read_nodes4() {
    begin_bytes();
    const std::int64_t blocks = numbers_.large("the number of blocks");
    const std::size_t n = numbers_.count(numbers_.large("the number of nodes"), "nodes", 28);
    numbers_.large("a number of a node");
    numbers_.large("a number of a node");
    lists_.points.reserve(n);
    std::vector<std::int64_t> tags;
    for (std::int64_t b = 0; b < blocks; ++b) {
      const std::int64_t dimension = numbers_.whole("a dimension");
      numbers_.whole("the number of an entity");
      const std::int64_t parametric = numbers_.whole("0 or 1");
      const std::size_t own = numbers_.count(numbers_.large("the number of nodes"), "nodes", 28);
      tags.clear();
      for (std::size_t k = 0; k < own; ++k) tags.push_back(numbers_.large("the number of a node"));
      for (const std::int64_t tag : tags) {
        add_node(tag, read_point());
        for (std::int64_t k = 0; parametric != 0 && k < std::min<std::int64_t>(dimension, 3); ++k) {
          numbers_.real("a parameter of a node");
        }
      }
    }
    end_nodes();
  }

  const ElementType* type_of(std::int64_t number) const {
    const auto* found = std::find_if(kTypes.begin(), kTypes.end(), [&](const ElementType& type) {
      return static_cast<std::int64_t>(type.number) == number;
    });
    return found == kTypes.end() ? nullptr : found;
  }
  const ElementType& known_type(std::int64_t number) const {
    const ElementType* type = type_of(number);
    if (type == nullptr) numbers_.fail(fmt::format("elements of type {} are not known", number));
    return *type;
  }

  void read_elements2() {
    const std::int64_t announced = scanner().integer(scanner().word(), "the number of elements");
    begin_bytes();
    const std::size_t n = numbers_.count(announced, "elements", 8);
    for (std::size_t done = 0; done < n;) {
      if (!numbers_.is_binary()) {
        const std::int64_t number = numbers_.whole("the number of an element");
        const ElementType& type = known_type(numbers_.whole("the type of an element"));
        read_element2(number, type, numbers_.whole("the number of tags"));
        ++done;
        continue;
      }
      const ElementType& type = known_type(numbers_.whole("the type of elements"));
      const std::size_t own =
          numbers_.count(numbers_.whole("the number of elements"), "elements", 8);
      const std::int64_t tags = numbers_.whole("the number of tags");
      if (own == 0) numbers_.fail("a block has no elements");
      for (std::size_t k = 0; k < own; ++k) {
        const std::int64_t number = numbers_.whole("the number of an element");
        read_element2(number, type, tags);
      }
      done += own;
    }
  }

  /// Reads an element of version 2, whose tags begin with the physical and the elementary group.
  void read_element2(std::int64_t number, const ElementType& type, std::int64_t tags) {
    const std::size_t n = numbers_.count(tags, "tags", 4);
    std::int64_t group = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const std::int64_t tag = numbers_.whole("a tag of an element");
      if (k == 0) group = tag;
    }
    read_element(number, type, group, [&] { return numbers_.whole("the number of a node"); });
  }

  void read_elements4() {
    begin_bytes();
    const std::int64_t blocks = numbers_.large("the number of blocks");
    for (int k = 0; k < 3; ++k) numbers_.large("a number of elements");
    for (std::int64_t b = 0; b < blocks; ++b) {
      numbers_.whole("a dimension");
      const std::int64_t entity = numbers_.whole("the number of an entity");
      const ElementType& type = known_type(numbers_.whole("the type of elements"));
      const std::size_t n = numbers_.count(numbers_.large("the number of elements"), "elements", 8);
      const auto group = group_of_.find(entity);
      for (std::size_t k = 0; k < n; ++k) {
        const std::int64_t number = numbers_.large("the number of an element");
        read_element(number, type, group == group_of_.end() ? 0 : group->second,
                     [&] { return numbers_.large("the number of a node"); });
      }
    }
  }

  template <class Next>
  void read_element(std::int64_t number, const ElementType& type, std::int64_t group,
                    const Next& next) {
    corners_.clear();
    for (std::size_t k = 0; k < type.nodes; ++k) {
      const std::int64_t tag = next();
      if (k >= type.corners) continue;
      const auto vertex = nodes_.vertex(tag);
      if (!vertex) {
        numbers_.fail(fmt::format("element {} refers to node {}, which is not there", number, tag));
      }
      corners_.push_back(*vertex);
    }
    if (type.dimension != 2) {
      (type.dimension == 3 ? volumes_ : less_) += 1;
      return;
    }
    add_polygon(lists_, corners_);
    curved_ |= type.nodes > type.corners;
    if (attributes_ != nullptr) groups_.resize(lists_.triangles.size(), group);
  }

  void tell() {
    if (volumes_ > 0) {
      lists_.notes.push_back(
          fmt::format("{} volumes of the file were left out; its triangles and quadrangles were "
                      "read, not the boundary of the volumes.",
                      volumes_));
    }
    if (less_ > 0) {
      lists_.notes.push_back(fmt::format("{} points and lines of the file were left out.", less_));
    }
    if (curved_) {
      lists_.notes.emplace_back("Of elements of higher order only the corners were taken.");
    }
  }

  /// Adds the face column `physical`, and the names of the groups as names of OBJ groups.
  void add_attributes() {
    if (std::all_of(groups_.begin(), groups_.end(), [](std::int64_t g) { return g == 0; })) return;
    AttributeColumn column{"physical", NumberType::kInt32, {groups_.begin(), groups_.end()}};
    attributes_->faces.push_back(std::move(column));
    if (names_.empty()) return;
    FaceNames names{"g", {""}, {}};
    std::map<std::int64_t, std::uint32_t> place;
    for (const auto& [tag, name] : names_) {
      place[tag] = static_cast<std::uint32_t>(names.names.size());
      names.names.push_back(name);
    }
    for (const std::int64_t group : groups_) {
      const auto found = place.find(group);
      names.of_face.push_back(found == place.end() ? 0 : found->second);
    }
    attributes_->names.push_back(std::move(names));
  }

  const MeshFile& file_;
  formats::MshNumbers numbers_;
  MeshAttributes* attributes_;
  MeshLists lists_;
  int version_ = 0;
  NodeNumbers nodes_;
  std::map<std::int64_t, std::string> names_;      // of physical groups of surfaces
  std::map<std::int64_t, std::int64_t> group_of_;  // of surfaces
  std::vector<std::uint32_t> corners_;
  std::vector<std::int64_t> groups_;  // of triangles
  std::size_t volumes_ = 0, less_ = 0;
  bool curved_ = false;
};

}  // namespace

MeshLists read_msh(const MeshFile& file, MeshAttributes* attributes) {
  return MshReader(file, attributes).read();
}

}  // namespace talweg
