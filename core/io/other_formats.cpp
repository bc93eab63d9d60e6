#include "talweg/core/io/other_formats.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "talweg/core/io/mesh_file.hpp"

namespace talweg {
namespace {

struct Kind {
  std::string_view extensions;  ///< each between blanks
  std::string_view advice;
};

constexpr std::string_view kVolume =
    ": it is a volume; segment it and make a surface of it first (3D Slicer exports segments as "
    ".ply, .obj or .stl)";

constexpr std::array<Kind, 8> kKinds{
    {{" .vtu .pvtu ",
      ": it holds a grid; extract its surface (in ParaView: Extract Surface) and save it as .vtp"},
     {" .vti .vts .vtr .vtm .pvtp .pvti .pvts .pvtr ",
      ": take a surface out of it first (in ParaView: Extract Surface, or Contour) and save it as "
      ".vtp"},
     {" .nii .mgz .mgh .nrrd .nhdr .mha .mhd .dcm .dicom .img .hdr .tif .tiff .minc .mnc ",
      kVolume},
     {" .step .stp .iges .igs .brep .sldprt .ipt .x_t .x_b .dxf .dwg .fcstd ",
      ": it holds CAD surfaces; mesh them first (with FreeCAD or Gmsh) and save them as .stl, .ply "
      "or .obj"},
     {" .dae .fbx .blend .usd .usda .usdc .usdz .3ds .abc .x3d .wrl .lwo .c4d .3dm .ctm .drc .x ",
      ": export it as .glb, .obj or .ply from the program that made it, or from Blender"},
     {" .mesh .meshb .inp .unv .cgns .exo .e .xdmf .med .bdf .nas ",
      ": convert its surface to .msh, .ply or .obj (with Gmsh or meshio)"},
     {" .xyz .pts .pcd .las .laz .e57 .asc ",
      ": it is a cloud of points; make a surface of it first (with MeshLab or CloudCompare)"},
     {" .zip .7z .bz2 .xz .zst .rar .tgz .tar ", ": unpack it first"}}};

std::string_view advice_on(const std::string& extension) {
  if (extension.empty()) return {};
  const std::string word = " " + extension + " ";
  const auto* found = std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& kind) {
    return kind.extensions.find(word) != std::string_view::npos;
  });
  return found == kKinds.end() ? std::string_view{} : found->advice;
}

}  // namespace

std::string instead_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension != ".gz") return std::string(advice_on(extension));
  const std::string_view inside = advice_on(lower_extension(path.stem()));
  return std::string(inside == kVolume ? kVolume : ": unpack it first (gunzip)");
}

}  // namespace talweg
