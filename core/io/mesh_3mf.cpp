// 3MF (3MF Consortium, "3D Manufacturing Format Core Specification"): a zip archive with XML. The
// objects of the build are placed by their transforms; components and models in other parts of the
// archive (the Production Extension) are followed.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <pugixml.hpp>

#include "talweg/core/io/face_naming.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/text_words.hpp"
#include "talweg/core/io/word_scanner.hpp"
#include "talweg/core/io/zip_archive.hpp"

namespace talweg {
namespace {

using Place = Eigen::Affine3d;

constexpr std::size_t kMostElements = std::size_t{1} << 25U;  // if objects are repeated
constexpr std::size_t kMostPlaced = std::size_t{1} << 16U;    // placed objects
constexpr std::size_t kDeepest = 64;                          // levels of components in components

/// One model part of the archive.
struct Model {
  std::string part, text;
  pugi::xml_document document;
  std::map<std::string, pugi::xml_node> objects;  // by id
  [[nodiscard]] pugi::xml_node root() const { return document.child("model"); }
};

class ThreeMfReader {
 public:
  ThreeMfReader(const MeshFile& file, MeshAttributes* attributes)
      : file_(file), archive_(file.path, file.bytes), attributes_(attributes) {}

  MeshLists read() {
    const Model& model = model_of(first_part());
    tell_unit(model);
    for (const pugi::xml_node item : model.root().child("build").children("item")) {
      add_object(model, item, Place::Identity(), 0);
    }
    if (lists_.triangles.empty()) {
      bad_file(file_.path, "its build has no triangles, so it holds no surface.");
    }
    if (supports_ > 0) {
      lists_.notes.push_back(fmt::format("{} supports of the build were left out.", supports_));
    }
    if (attributes_ != nullptr) {
      objects_.give(*attributes_);
      if (has_materials_) attributes_->left_out.emplace_back("materials and colours (3MF)");
    }
    return std::move(lists_);
  }

 private:
  /// The part that the relationships of the archive name as the model.
  std::string first_part() const {
    if (archive_.has("_rels/.rels")) {
      pugi::xml_document rels;
      const std::string text = archive_.read("_rels/.rels");
      rels.load_buffer(text.data(), text.size());
      for (const pugi::xml_node rel : rels.child("Relationships").children("Relationship")) {
        const std::string_view type = rel.attribute("Type").value();
        if (type.ends_with("/3dmodel")) return without_slash(rel.attribute("Target").value());
      }
    }
    return "3D/3dmodel.model";
  }
  static std::string without_slash(std::string name) {
    if (name.starts_with('/')) name.erase(0, 1);
    return name;
  }

  const Model& model_of(const std::string& part) {
    std::unique_ptr<Model>& model = models_[part];
    if (model) return *model;
    model = std::make_unique<Model>();
    model->part = part;
    model->text = archive_.read(part);
    unpacked_ += model->text.size();
    const auto result = model->document.load_buffer(model->text.data(), model->text.size());
    if (!result) {
      const auto at = static_cast<std::size_t>(result.offset);
      bad_file(file_.path,
               fmt::format("{}, line {}: it is not well-formed XML ({}).", printable(part),
                           formats::line_of(model->text, at), result.description()));
    }
    if (!model->root()) {
      bad_file(file_.path, fmt::format("{}: expected <model>.", printable(part)));
    }
    for (const pugi::xml_node object : model->root().child("resources").children("object")) {
      model->objects.emplace(object.attribute("id").value(), object);
    }
    return *model;
  }

  [[noreturn]] void fail(const Model& model, const pugi::xml_node& node,
                         const std::string& what) const {
    const std::ptrdiff_t at = node ? node.offset_debug() : 0;
    const std::size_t line =
        formats::line_of(model.text, at > 0 ? static_cast<std::size_t>(at) : 0);
    bad_file(file_.path, fmt::format("{}, line {}, <{}>: {}.", printable(model.part), line,
                                     printable(node.name()), what));
  }

  void tell_unit(const Model& model) {
    const std::string_view unit = model.root().attribute("unit").as_string("millimeter");
    using Named = std::pair<std::string_view, std::string_view>;
    constexpr std::array<Named, 6> kUnits{Named{"micron", "um"},     Named{"millimeter", "mm"},
                                          Named{"centimeter", "cm"}, Named{"inch", "in"},
                                          Named{"foot", "ft"},       Named{"meter", "m"}};
    const auto* known = std::find_if(kUnits.begin(), kUnits.end(),
                                     [&](const Named& named) { return named.first == unit; });
    if (known == kUnits.end()) {
      fail(model, model.root(),
           fmt::format("expected a unit from micron to meter, found '{}'", printable(unit)));
    }
    lists_.unit = LengthUnit::named(known->second);
  }

  double number(const Model& model, const pugi::xml_node& node, const char* name) const {
    const std::string_view word = node.attribute(name).value();
    double value = 0;
    if (!parse(word, value)) {
      fail(model, node, fmt::format("expected a number for {}, found '{}'", name, printable(word)));
    }
    return value;
  }

  /// The transform of a node: twelve numbers, the rows of a 4 × 3 matrix that multiplies row
  /// vectors from the right.
  Place place_of(const Model& model, const pugi::xml_node& node) const {
    Place place = Place::Identity();
    const pugi::xml_attribute given = node.attribute("transform");
    if (!given) return place;
    formats::WordScanner words(file_.path, given.value());
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 3; ++column) {
        double value = 0;
        if (!parse(words.word(), value) || !(std::abs(value) < 1e40)) {
          fail(model, node, "expected twelve numbers as transform");
        }
        place.matrix()(column, row) = value;
      }
    }
    return place;
  }

  /// Adds the object that an item of the build or a component names.
  void add_object(const Model& from, const pugi::xml_node& item, const Place& outer,
                  std::size_t depth) {
    if (depth > kDeepest) fail(from, item, "components nest deeper than 64 levels");
    if (++placed_ > kMostPlaced) fail(from, item, "there are more than 65536 objects");
    const pugi::xml_attribute path = item.find_attribute(
        [](const pugi::xml_attribute& a) { return std::string_view(a.name()).ends_with(":path"); });
    const Model& model = path ? model_of(without_slash(path.value())) : from;
    const std::string id = item.attribute("objectid").value();
    const auto found = model.objects.find(id);
    if (found == model.objects.end()) {
      fail(from, item, fmt::format("there is no object '{}'", printable(id)));
    }
    const pugi::xml_node object = found->second;
    const std::string_view type = object.attribute("type").value();
    if (type == "support" || type == "solidsupport") {
      ++supports_;
      return;
    }
    const Place place = outer * place_of(from, item);
    if (object.child("mesh")) add_mesh(model, object, place);
    for (const pugi::xml_node component : object.child("components").children("component")) {
      add_object(model, component, place, depth + 1);
    }
  }

  void add_mesh(const Model& model, const pugi::xml_node& object, const Place& place) {
    const pugi::xml_node mesh = object.child("mesh");
    const std::size_t first = lists_.points.size();
    const bool moved = place.matrix() != Eigen::Matrix4d::Identity();
    for (const pugi::xml_node vertex : mesh.child("vertices").children("vertex")) {
      const Point p(number(model, vertex, "x"), number(model, vertex, "y"),
                    number(model, vertex, "z"));
      lists_.points.push_back(moved ? Point(place * p) : p);
    }
    const std::size_t own = lists_.points.size() - first;
    const bool mirrored = place.linear().determinant() < 0;
    for (const pugi::xml_node node : mesh.child("triangles").children("triangle")) {
      Triangle t{};
      constexpr std::array<const char*, 3> kNames{"v1", "v2", "v3"};
      for (std::size_t k = 0; k < 3; ++k) {
        const double v = number(model, node, kNames[k]);
        if (!(v >= 0 && v < static_cast<double>(own)) || v != std::floor(v)) {
          fail(model, node,
               fmt::format("{} is {:.17g}, but the object has {} vertices", kNames[k], v, own));
        }
        t[k] = static_cast<std::uint32_t>(first + static_cast<std::size_t>(v));
      }
      if (mirrored) std::swap(t[1], t[2]);
      lists_.triangles.push_back(t);
      has_materials_ = has_materials_ || node.attribute("pid") || node.attribute("p1");
    }
    const std::size_t most = std::max(lists_.points.size(), lists_.triangles.size());
    if (most > std::max(kMostElements, unpacked_)) {
      fail(model, object,
           fmt::format("with this object the build has {} vertices or triangles, many of "
                       "them repeated; expected at most {}",
                       most, kMostElements));
    }
    has_materials_ = has_materials_ || object.attribute("pid");
    if (attributes_ != nullptr) {
      objects_.add(object.attribute("name").value(), lists_.triangles.size());
    }
  }

  const MeshFile& file_;
  formats::ZipArchive archive_;
  MeshAttributes* attributes_;
  MeshLists lists_;
  std::map<std::string, std::unique_ptr<Model>> models_;  // by part
  formats::FaceNaming objects_{"o"};
  std::size_t placed_ = 0, supports_ = 0, unpacked_ = 0;
  bool has_materials_ = false;
};

}  // namespace

MeshLists read_3mf(const MeshFile& file, MeshAttributes* attributes) {
  return ThreeMfReader(file, attributes).read();
}

}  // namespace talweg
