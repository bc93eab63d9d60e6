#include "talweg/core/io/label_writer.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/label_bytes.hpp"
#include "talweg/core/io/mesh_bytes.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/text_words.hpp"

namespace talweg {
namespace formats {

std::string text_labels(const LabelContent& content) {
  std::string text;
  for (const std::int64_t label : content.labels.labels) {
    fmt::format_to(std::back_inserter(text), "{}\n", label);
  }
  return text;
}

std::string csv_labels(const LabelContent& content) {
  std::string text = content.labels.of_faces ? "face,label\n" : "vertex,label\n";
  std::size_t number = 0;
  for (const std::int64_t label : content.labels.labels) {
    fmt::format_to(std::back_inserter(text), "{},{}\n", number++, label);
  }
  return text;
}

std::string npy_labels(const LabelContent& content) {
  constexpr std::size_t kBefore = 10, kAlignment = 64;  // bytes before the header in version 1
  std::string header = fmt::format("{{'descr': '<i8', 'fortran_order': False, 'shape': ({},), }}",
                                   content.labels.labels.size());
  while ((kBefore + header.size() + 1) % kAlignment != 0) header.push_back(' ');
  header.push_back('\n');
  std::string bytes("\x93NUMPY\x01\x00", 8);
  put(bytes, static_cast<std::uint16_t>(header.size()));
  bytes += header;
  for (const std::int64_t label : content.labels.labels) put(bytes, label);
  return bytes;
}

std::string dpv_labels(const LabelContent& content) {
  std::string text;
  for (std::size_t v = 0; v < content.labels.labels.size(); ++v) {
    const Point& p = content.mesh.points[v];
    fmt::format_to(std::back_inserter(text), "{:03} {} {} {} {}\n", v, p.x(), p.y(), p.z(),
                   content.labels.labels[v]);
  }
  return text;
}

std::string freesurfer_label(const LabelContent& content) {
  const std::vector<std::int64_t>& labels = content.labels.labels;
  const auto is_other = [](std::int64_t label) { return label == 0 || label == -1; };
  const auto one = std::find_if_not(labels.begin(), labels.end(), is_other);
  std::string lines;
  std::size_t count = 0;
  for (std::size_t v = 0; v < labels.size(); ++v) {
    if (is_other(labels[v])) continue;
    if (labels[v] != *one) {
      cannot_write(
          content.path,
          fmt::format("a .label holds one label besides 0 and -1, but the labels include {} "
                      "and {} (.annot and .label.gii hold all)",
                      *one, labels[v]));
    }
    const Point& p = content.mesh.points[v];
    fmt::format_to(std::back_inserter(lines), "{} {} {} {} {}\n", v, p.x(), p.y(), p.z(), *one);
    ++count;
  }
  return fmt::format("#!ascii label\n{}\n{}", count, lines);
}

}  // namespace formats

namespace {

struct LabelFormat {
  std::string_view extension;
  std::string (*bytes)(const formats::LabelContent&);
  bool of_vertices_only = false;
  bool is_list = false;
};

constexpr LabelFormat kLabelFormats[] = {{"", formats::text_labels, false, true},
                                         {".txt", formats::text_labels, false, true},
                                         {".labels", formats::text_labels, false, true},
                                         {".csv", formats::csv_labels, false, true},
                                         {".npy", formats::npy_labels, false, true},
                                         {".dpv", formats::dpv_labels, true, false},
                                         {".annot", formats::annot_labels, true, false},
                                         {".label", formats::freesurfer_label, true, false},
                                         {".gii", formats::gifti_labels, true, false},
                                         {".ply", formats::ply_labels, false, false},
                                         {".vtk", formats::vtk_labels, false, false},
                                         {".vtp", formats::vtp_labels, false, false}};

/// The format with the extension of a name; null if there is none. "-.csv" has the extension .csv.
const LabelFormat* format_of(const std::filesystem::path& name) {
  const std::string extension = lower_extension(name);
  for (const LabelFormat& format : kLabelFormats) {
    if (format.extension == extension) return &format;
  }
  return nullptr;
}

[[noreturn]] void refuse(const std::filesystem::path& name, const char* known) {
  cannot_write(name, fmt::format("no format of labels has the extension '{}'; known are {}",
                                 printable(lower_extension(name)), known));
}

}  // namespace

std::string label_bytes(const std::filesystem::path& name, const LabelOutput& output,
                        const MeshLists& mesh, const MeshAttributes& attributes) {
  check_label_name(name);
  check_label_kind(name, output.of_faces);
  const LabelFormat& format = *format_of(name);
  const std::size_t expected = output.of_faces ? mesh.triangles.size() : mesh.points.size();
  if (!format.is_list && output.labels.size() != expected) {
    cannot_write(name,
                 fmt::format("there are {} labels, but the mesh has {} {}", output.labels.size(),
                             expected, output.of_faces ? "faces" : "vertices"));
  }
  return format.bytes({name, output, mesh, attributes});
}

void check_label_name(const std::filesystem::path& name) {
  if (format_of(name) != nullptr) return;
  refuse(name, ".txt .csv .npy .dpv .annot .label .gii .ply .vtk .vtp");
}

void check_label_kind(const std::filesystem::path& name, bool of_faces) {
  const LabelFormat* format = format_of(name);
  if (format == nullptr || !of_faces || !format->of_vertices_only) return;
  cannot_write(name, fmt::format("a {} holds labels of vertices, but the labels are those of faces",
                                 format->extension));
}

bool is_label_list(const std::filesystem::path& name) {
  const LabelFormat* format = format_of(name);
  return format != nullptr && format->is_list;
}

void check_label_list_name(const std::filesystem::path& name) {
  if (!is_label_list(name)) refuse(name, ".txt .csv .npy");
}

}  // namespace talweg
