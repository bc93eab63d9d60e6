#include "mesh_files.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "file_attributes.hpp"
#include "methods/file_calls.hpp"
#include "methods/host_mesh.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/mesh_reader.hpp"
#include "talweg/core/io/mesh_writer.hpp"

namespace talweg::plugins {
namespace {

std::vector<const char*> c_strings(const std::vector<std::string>& texts) {
  std::vector<const char*> result;
  result.reserve(texts.size());
  for (const std::string& text : texts) result.push_back(text.c_str());
  return result;
}

void tell_all(const std::vector<std::string>& texts, talweg_text_function tell, void* context) {
  if (tell == nullptr) return;
  for (const std::string& text : texts) tell(context, text.c_str());
}

/// The views of a file's mesh for the interface. The viewed lists must outlive them.
class FileView {
 public:
  FileView(const MeshLists& lists, const MeshAttributes& attributes)
      : attributes_(grouped(attributes)),
        references_(c_strings(attributes.references)),
        frame_(frame_text(lists.unit, lists.space)) {
    view_mesh(lists);
    for (const HostAttribute& attribute : attributes_) {
      const auto& view = views_.emplace_back(std::make_unique<AttributeView>(attribute));
      attribute_pointers_.push_back(&view->view());
    }
    names_.reserve(attributes.names.size());
    for (const FaceNames& names : attributes.names) {
      const auto& strings = names_.emplace_back(c_strings(names.names));
      name_lists_.push_back({sizeof(talweg_name_list), static_cast<std::uint32_t>(strings.size()),
                             names.keyword.c_str(), strings.data()});
    }
    for (const talweg_name_list& list : name_lists_) name_list_pointers_.push_back(&list);
    view_ = {sizeof view_,
             static_cast<std::uint32_t>(attributes_.size()),
             &mesh_,
             attribute_pointers_.data(),
             static_cast<std::uint32_t>(name_lists_.size()),
             static_cast<std::uint32_t>(references_.size()),
             name_list_pointers_.data(),
             references_.data(),
             lists.polygon_count,
             plugin::kNoArray,
             frame_.c_str()};
  }
  FileView(const FileView&) = delete;
  FileView& operator=(const FileView&) = delete;
  [[nodiscard]] const talweg_mesh_file& view() const { return view_; }

 private:
  void view_mesh(const MeshLists& lists) {
    mesh_.size = sizeof mesh_;
    const double* first = lists.points.empty() ? nullptr : lists.points.front().data();
    mesh_.positions = plugin::view(first, lists.points.size(), 3);
    if (lists.single_precision && first != nullptr) {
      single_.assign(first, first + 3 * lists.points.size());
      mesh_.positions = {single_.data(), lists.points.size(), 0, 3, TALWEG_FLOAT32};
    }
    mesh_.triangles =
        plugin::view(lists.triangles.empty() ? nullptr : lists.triangles.front().data(),
                     lists.triangles.size(), 3);
  }

  talweg_mesh mesh_ = {};
  std::vector<float> single_;
  std::vector<HostAttribute> attributes_;
  std::vector<std::unique_ptr<AttributeView>> views_;
  std::vector<const talweg_attribute*> attribute_pointers_;
  std::vector<std::vector<const char*>> names_;
  std::vector<talweg_name_list> name_lists_;
  std::vector<const talweg_name_list*> name_list_pointers_;
  std::vector<const char*> references_;
  std::string frame_;
  talweg_mesh_file view_ = {};
};

talweg_status read(const char* path, talweg_mesh_file_function take, talweg_text_function left_out,
                   void* context, char* message, std::uint64_t message_size) noexcept {
  return attempt(message, message_size, [&] {
    if (path == nullptr || take == nullptr) bad_call("The path or the function is null.");
    MeshAttributes attributes;
    const MeshLists lists = read_mesh(path, attributes);
    tell_all(attributes.left_out, left_out, context);
    tell_all(lists.notes, left_out, context);
    const FileView file(lists, attributes);
    if (take(context, &file.view()) != TALWEG_OK) {
      throw plugin::Failure(TALWEG_HOST_FAILED, "The host refused the mesh.");
    }
  });
}

template <class T>
std::span<const T> list_of(const T* first, std::uint32_t count, const char* what) {
  if (count > 0 && first == nullptr) bad_call(what);
  return {first, count};
}

/// A host's mesh before it is written.
class Content {
 public:
  Content(const std::string& path, const talweg_mesh_file& file) {
    check_mesh_name(path);
    lists_ = lists_of(plugin::checked(file.mesh, "The mesh"));
    HostAttributes attributes;
    const auto given = list_of(file.attributes, file.attribute_count, "The attributes are null.");
    for (const talweg_attribute* one : given) plugin::checked(one, "An attribute");
    attributes.set(given, lists_.points.size(), lists_.triangles.size());
    attributes_ = in_columns(attributes.all(), left_out_);
    const auto names = list_of(file.name_lists, file.name_list_count, "The name lists are null.");
    for (const talweg_name_list* list : names) {
      take_names(plugin::checked(list, "A list of names"), lower_extension(path) == ".obj");
    }
    take_references(file);
    take_edges(file.edges);
    take_frame(file);
  }

  void write(const std::string& path, talweg_text_function left_out, void* context) {
    auto more = write_mesh(path, lists_, attributes_, edges_);
    left_out_.insert(left_out_.end(), more.begin(), more.end());
    tell_all(left_out_, left_out, context);
  }

 private:
  static std::string line_of(const char* text, const char* what) {
    if (text == nullptr) bad_call(fmt::format("{} is null.", what));
    std::string line = text;
    if (line.find_first_of("\r\n") != std::string::npos) {
      bad_call(fmt::format("{} has more than one line.", what));
    }
    return line;
  }

  /// Reads a list of names. Only OBJ holds names; in other formats the attribute stays a column.
  void take_names(const talweg_name_list& list, bool held) {
    FaceNames names;
    names.keyword = line_of(list.attribute, "The attribute of a list of names");
    auto& columns = attributes_.faces;
    const auto column = std::find_if(columns.begin(), columns.end(),
                                     [&](const auto& c) { return c.name == names.keyword; });
    if (column == columns.end()) {
      bad_call(fmt::format("There are names for the attribute \"{}\", which triangles do not have.",
                           names.keyword));
    }
    if (!held) {
      left_out_.push_back(fmt::format("names of faces ({})", names.keyword));
      return;
    }
    const auto texts = list_of(list.names, list.count, "The names are null.");
    names.names.clear();
    for (const char* text : texts) names.names.push_back(line_of(text, "A name"));
    for (const double value : column->values) {
      if (!(value >= 0 && value < static_cast<double>(texts.size()))) {
        bad_call(fmt::format("The attribute \"{}\" has the value {}, but only {} names.",
                             names.keyword, value, texts.size()));
      }
      names.of_face.push_back(static_cast<std::uint32_t>(value));
    }
    columns.erase(column);
    attributes_.names.push_back(std::move(names));
  }

  void take_references(const talweg_mesh_file& file) {
    const auto lines = list_of(file.references, file.reference_count, "The references are null.");
    for (const char* line : lines) {
      attributes_.references.push_back(line_of(line, "A reference"));
    }
  }

  void take_edges(const talweg_array& edges) {
    const auto numbers = plugin::indices_of(edges, 3, "The edges");
    for (std::size_t k = 0; k < numbers.size(); k += 3) {
      for (const std::uint32_t v : {numbers[k], numbers[k + 1]}) {
        if (v < lists_.points.size()) continue;
        bad_call(fmt::format("An edge has the vertex {}, and the mesh has {}.", v,
                             lists_.points.size()));
      }
      edges_.push_back({numbers[k], numbers[k + 1], numbers[k + 2]});
    }
  }

  void take_frame(const talweg_mesh_file& file) {
    if (file.size < sizeof file || file.frame == nullptr) return;  // a host of interface 1.2
    lists_.space = frame_named(file.frame).space;
  }

  MeshLists lists_;
  MeshAttributes attributes_;
  std::vector<TaggedEdge> edges_;
  std::vector<std::string> left_out_;
};

talweg_status write(const char* path, const talweg_mesh_file* file, talweg_text_function left_out,
                    void* context, char* message, std::uint64_t message_size) noexcept {
  return attempt(message, message_size, [&] {
    if (path == nullptr) bad_call("The path is null.");
    if (file == nullptr || file->size < offsetof(talweg_mesh_file, frame)) {
      bad_call("The file is null or too small.");
    }
    Content(path, *file).write(path, left_out, context);
  });
}

}  // namespace

const talweg_mesh_files* mesh_files() {
  static constexpr talweg_mesh_files kFiles = {sizeof kFiles, 0, read, write};
  return &kFiles;
}

}  // namespace talweg::plugins
