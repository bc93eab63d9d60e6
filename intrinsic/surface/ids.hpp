// Ids of mesh elements are numbers of different types, which do not mix.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>

namespace talweg {

/// A 32-bit index of one kind of element. Indices of different kinds neither compare nor convert.
/// A default-constructed index is invalid.
template <class Kind>
class Id {
 public:
  static constexpr std::uint32_t kInvalid = std::numeric_limits<std::uint32_t>::max();

  constexpr Id() = default;
  constexpr explicit Id(std::size_t value) : value_(static_cast<std::uint32_t>(value)) {}

  [[nodiscard]] constexpr std::size_t index() const { return value_; }
  [[nodiscard]] constexpr bool valid() const { return value_ != kInvalid; }

  friend constexpr bool operator==(Id, Id) = default;
  friend constexpr std::strong_ordering operator<=>(Id, Id) = default;

 private:
  std::uint32_t value_ = kInvalid;
};

using VertexId = Id<struct VertexKind>;
using EdgeId = Id<struct EdgeKind>;
using FaceId = Id<struct FaceKind>;
/// Edge e owns the halfedges 2e and 2e + 1.
using HalfedgeId = Id<struct HalfedgeKind>;

constexpr HalfedgeId twin(HalfedgeId h) { return HalfedgeId{h.index() ^ 1U}; }
constexpr EdgeId edge_of(HalfedgeId h) { return EdgeId{h.index() >> 1U}; }
/// The edge's own direction: a parameter t on an edge runs along this halfedge.
constexpr HalfedgeId halfedge_of(EdgeId e) { return HalfedgeId{2 * e.index()}; }

}  // namespace talweg
/// @cond
template <class Kind>
struct std::hash<talweg::Id<Kind>> {
  std::size_t operator()(talweg::Id<Kind> id) const noexcept { return id.index(); }
};
/// @endcond
