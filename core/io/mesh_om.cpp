// OpenMesh's OM: positions and polygons. Versions before 2 list the corners of each face, later
// versions the halfedges. Other chunks are skipped.
#include <algorithm>
#include <optional>
#include <vector>

#include "talweg/core/io/byte_cursor.hpp"
#include "talweg/core/io/mesh_file.hpp"

namespace talweg {
namespace {

enum Entity : unsigned { kVertex = 0, kMesh = 1, kFace = 2, kEdge = 4, kHalfedge = 6, kEnd = 7 };
enum Content : unsigned { kPosition = 0, kStatus = 3, kCustom = 6, kTopology = 7 };

/// A chunk begins with 16 bits that describe its content.
struct Chunk {
  explicit Chunk(unsigned bits)
      : named((bits >> 1U) & 1U),
        entity((bits >> 2U) & 7U),
        content((bits >> 5U) & 15U),
        is_float((bits >> 10U) & 1U),
        dimensions(((bits >> 11U) & 7U) + 1),
        size_code((bits >> 14U) & 3U) {}

  unsigned named;
  unsigned entity;
  unsigned content;
  unsigned is_float;
  unsigned dimensions;
  unsigned size_code;
};

class OmReader {
 public:
  explicit OmReader(const MeshFile& file) : file_(file), cursor_(file.bytes) {}

  MeshLists read() {
    read_header();
    while (!complete() && cursor_.left() > 0) {
      const Chunk chunk(number<std::uint16_t>("a chunk"));
      if (chunk.entity == kEnd) break;
      read_chunk(chunk);
    }
    if (!complete()) bad_file(file_.path, "the file ends before all its vertices and faces.");
    has_more_ |= cursor_.left() > 2;  // more than the chunk that ends the file
    if (major_ >= 2) faces_from_halfedges();
    return std::move(lists_);
  }
  [[nodiscard]] bool has_more() const { return has_more_; }

 private:
  template <class T>
  T number(const char* what) {
    const char* at = cursor_.take(sizeof(T));
    if (at == nullptr) bad_file(file_.path, "the file ends in " + std::string(what) + ".");
    return load<T>(at, std::endian::native == std::endian::big);
  }
  /// Memory is only allocated for elements whose bytes exist.
  void need(std::size_t count, std::size_t size, const char* what) const {
    if (count * size > cursor_.left()) {
      bad_file(file_.path, "the file ends in " + std::string(what) + ".");
    }
  }
  /// An index of 1, 2 or 4 bytes; the largest value means none.
  std::uint32_t index(const Chunk& chunk, const char* what) {
    if (chunk.size_code == 0) return widen(number<std::uint8_t>(what));
    if (chunk.size_code == 1) return widen(number<std::uint16_t>(what));
    if (chunk.size_code == 2) return number<std::uint32_t>(what);
    bad_file(file_.path, "indices of 64 bits are not supported.");
  }
  template <class T>
  static std::uint32_t widen(T value) {
    return value == static_cast<T>(-1) ? kNone : value;
  }

  void read_header() {
    const char* magic = cursor_.take(4);
    if (magic == nullptr || magic[0] != 'O' || magic[1] != 'M') {
      bad_file(file_.path, "this is not an OM file: it does not begin with the letters OM.");
    }
    mesh_ = magic[2];
    major_ = static_cast<unsigned char>(magic[3]) >> 5U;
    if (major_ > 2) {
      bad_file(file_.path, "OM files of version " + std::to_string(major_) + " are not supported.");
    }
    vertices_ = number<std::uint32_t>("the header");
    faces_ = number<std::uint32_t>("the header");
    edges_ = number<std::uint32_t>("the header");
    // Every element takes bytes, so a file cannot have more elements than bytes.
    if (std::max({vertices_, faces_, edges_}) > file_.bytes.size()) {
      bad_file(file_.path, "its header announces " + std::to_string(vertices_) + " vertices and " +
                               std::to_string(faces_) + " faces, but it has only " +
                               std::to_string(file_.bytes.size()) + " bytes.");
    }
  }

  [[nodiscard]] bool complete() const {
    const bool has_faces = major_ >= 2 ? has_halfedges_ && has_first_ : has_first_;
    return (has_points_ || vertices_ == 0) && (has_faces || faces_ == 0);
  }

  void read_chunk(const Chunk& chunk) {
    if (chunk.named != 0 || chunk.content == kCustom) {
      bad_file(file_.path, "properties that come before the faces are not supported.");
    }
    if (chunk.entity == kVertex && chunk.content == kPosition) {
      read_points(chunk);
    } else if (chunk.entity == kHalfedge && chunk.content == kTopology) {
      read_halfedges(chunk);
    } else if (chunk.entity == kFace && chunk.content == kTopology) {
      major_ >= 2 ? read_first_halfedges(chunk) : read_face_corners(chunk);
    } else {
      pass(chunk);
    }
  }

  void read_points(const Chunk& chunk) {
    if (chunk.is_float == 0 || chunk.dimensions != 3 || chunk.size_code > 1) {
      bad_file(file_.path, "the positions are not three floating-point numbers each.");
    }
    need(vertices_, std::size_t{12} << chunk.size_code, "the positions");
    lists_.single_precision = chunk.size_code == 0;
    lists_.points.resize(vertices_);
    for (Point& p : lists_.points) {
      for (double& x : p) {
        x = chunk.size_code == 0 ? static_cast<double>(number<float>("the positions"))
                                 : number<double>("the positions");
      }
    }
    has_points_ = true;
  }

  void read_face_corners(const Chunk& chunk) {
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < faces_; ++f) {
      const std::size_t n = mesh_ == 'T'   ? 3
                            : mesh_ == 'Q' ? 4
                                           : number<std::uint16_t>("the faces");
      corners.clear();
      for (std::size_t k = 0; k < n; ++k) corners.push_back(index(chunk, "the faces"));
      add_face(f, corners);
    }
    has_first_ = true;
  }

  void read_halfedges(const Chunk& chunk) {
    need(2 * edges_, std::size_t{3} << chunk.size_code, "the halfedges");
    halfedges_.resize(2 * edges_);
    for (Halfedge& h : halfedges_) {
      h.next = index(chunk, "the halfedges");
      h.head = index(chunk, "the halfedges");
      index(chunk, "the halfedges");  // skips its face, which is read from the face's own chunk
    }
    has_halfedges_ = true;
  }

  void read_first_halfedges(const Chunk& chunk) {
    need(faces_, std::size_t{1} << chunk.size_code, "the faces");
    first_.resize(faces_);
    for (std::uint32_t& h : first_) h = index(chunk, "the faces");
    has_first_ = true;
  }

  void pass(const Chunk& chunk) {
    has_more_ |= chunk.content != kStatus && chunk.content != kTopology;
    std::size_t count = 1;
    if (chunk.entity == kVertex) count = vertices_;
    if (chunk.entity == kFace) count = faces_;
    if (chunk.entity == kEdge) count = edges_;
    if (chunk.entity == kHalfedge) count = 2 * edges_;
    std::size_t size = std::size_t{chunk.is_float != 0 ? 4U : 1U} << chunk.size_code;
    size *= chunk.content == kTopology || chunk.content == kStatus ? 1 : chunk.dimensions;
    if (chunk.content == kTopology || chunk.content == kStatus)
      size = std::size_t{1} << chunk.size_code;
    if (cursor_.take(count * size) == nullptr) bad_file(file_.path, "the file ends in a chunk.");
  }

  void faces_from_halfedges() {
    std::size_t corners_seen = 0;
    std::vector<std::uint32_t> corners;
    for (std::size_t f = 0; f < faces_; ++f) {
      corners.clear();
      // A face starts at the head of its halfedge, which is the first vertex that OpenMesh was
      // given.
      std::uint32_t h = first_[f];
      do {
        // A halfedge belongs to one face, so all faces together have no more corners.
        if (h >= halfedges_.size() || ++corners_seen > halfedges_.size()) {
          bad_file(file_.path, "the halfedges of face " + std::to_string(f) + " do not close.");
        }
        corners.push_back(halfedges_[h].head);
        h = halfedges_[h].next;
      } while (h != first_[f]);
      add_face(f, corners);
    }
  }

  void add_face(std::size_t f, const std::vector<std::uint32_t>& corners) {
    if (corners.size() < 3) {
      bad_file(file_.path, "face " + std::to_string(f) + " has " + std::to_string(corners.size()) +
                               " corners, but a face needs three or more.");
    }
    for (const std::uint32_t v : corners) {
      if (v >= vertices_) {
        bad_file(file_.path, "face " + std::to_string(f) + " refers to vertex " +
                                 std::to_string(v) + ", but the file has " +
                                 std::to_string(vertices_) + " vertices.");
      }
    }
    add_polygon(lists_, corners);
  }

  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  struct Halfedge {
    std::uint32_t next = kNone;
    std::uint32_t head = kNone;
  };

  const MeshFile& file_;
  ByteCursor cursor_;
  MeshLists lists_;
  char mesh_ = 'T';
  unsigned major_ = 0;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::size_t edges_ = 0;
  bool has_points_ = false;
  bool has_halfedges_ = false;
  bool has_first_ = false;
  bool has_more_ = false;  // whether the file has more than positions and faces
  std::vector<Halfedge> halfedges_;
  std::vector<std::uint32_t> first_;
};

}  // namespace

MeshLists read_om(const MeshFile& file, MeshAttributes* attributes) {
  OmReader reader(file);
  MeshLists lists = reader.read();
  if (attributes != nullptr && reader.has_more()) {
    attributes->left_out.emplace_back("properties besides positions and faces (OM)");
  }
  return lists;
}

}  // namespace talweg
