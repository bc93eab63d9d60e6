// Each label format has its own writer behind label_writer.hpp: labels to the bytes of a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "talweg/core/io/label_writer.hpp"

namespace talweg::formats {

/// The input of a writer; the path is for its messages.
struct LabelContent {
  const std::filesystem::path& path;
  const LabelOutput& labels;
  const MeshLists& mesh;
  const MeshAttributes& attributes;
};

std::string text_labels(const LabelContent& content);
std::string csv_labels(const LabelContent& content);
std::string npy_labels(const LabelContent& content);
std::string dpv_labels(const LabelContent& content);
std::string annot_labels(const LabelContent& content);
std::string freesurfer_label(const LabelContent& content);
std::string gifti_labels(const LabelContent& content);
std::string ply_labels(const LabelContent& content);
std::string vtk_labels(const LabelContent& content);
std::string vtp_labels(const LabelContent& content);

/// An entry of a table of labels.
struct NamedLabel {
  std::string name;
  LabelColor color{};
};
/// All labels that occur or have a name, each with a name and a color. A label without a name is
/// called "label_7"; -1 is "???" without color.
std::map<std::int64_t, NamedLabel> table_of(const LabelFile& labels);

}  // namespace talweg::formats
