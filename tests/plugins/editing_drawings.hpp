// Editing drawings are made as a hand makes them: by random edits.
#pragma once

#include <algorithm>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "core/generated_meshes.hpp"
#include "talweg/editing/editor.hpp"
#include "talweg/editing/mesh_arrays.hpp"

namespace talweg::test {

inline editing::MeshArrays arrays_of(const MeshLists& lists) {
  editing::MeshArrays arrays;
  for (const auto& p : lists.points) arrays.positions.push_back({p[0], p[1], p[2]});
  for (const auto& t : lists.triangles) {
    arrays.triangles.push_back({static_cast<std::uint32_t>(t[0]), static_cast<std::uint32_t>(t[1]),
                                static_cast<std::uint32_t>(t[2])});
  }
  return arrays;
}

/// A point inside a face.
inline editing::Point at(std::uint32_t face) { return {face, {0.25, 0.25, 0.5}}; }

/// The sentence with which an edit is refused.
template <class Edit>
std::string refusal(Edit edit) {
  try {
    edit();
  } catch (const editing::Error& error) {
    return error.what();
  }
  return "no refusal";
}

/// A drawing with nothing shared, so that no later edit could reach it.
inline editing::Drawing deep_copy(const editing::Drawing& drawing) {
  editing::Drawing copy;
  for (const auto& curve : drawing.curves) {
    copy.curves.push_back(std::make_shared<const editing::Curve>(*curve));
  }
  copy.unfinished = drawing.unfinished;
  copy.settings = drawing.settings;
  return copy;
}

/// Makes edits at random; those that are not possible just then are left out.
class RandomHand {
 public:
  RandomHand(std::uint32_t seed, std::uint32_t faces) : random_(seed), faces_(faces) {}

  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(random_() % n); }
  double number() { return static_cast<double>(random_() % 100000) / 7.0; }

  editing::Point point() {
    return editing::picked(below(faces_), {number() + 1, number(), number()});
  }

  /// False where the editor refused.
  bool edit(editing::Editor& editor) {
    try {
      const std::uint32_t kind = below(20);
      if (kind < 8) {
        editor.add_point(point());
      } else if (kind < 15) {
        edit_curve(editor, kind);
      } else {
        edit_settings(editor, kind);
      }
    } catch (const editing::Error&) {
      return false;
    }
    return true;
  }

 private:
  void edit_curve(editing::Editor& editor, std::uint32_t kind) {
    const std::size_t count = editor.drawing().curves.size();
    const std::size_t c = below(count + 1);  // sometimes one that is not there
    const std::size_t points = c < count ? editor.drawing().curves[c]->points.size() : 1;
    const std::size_t p = below(points + 1);
    switch (kind) {
      case 8:
        return editor.finish_curve();
      case 9:
        return below(2) == 0 ? editor.close_curve() : editor.take_back_point();
      case 10:
        return editor.move_point(c, p, point());
      case 11:
        return editor.insert_point(c, p, point());
      case 12:
        return below(2) == 0 ? editor.set_pinned(c, p, below(2) == 0) : edit_own(editor, c);
      case 13:
        return below(2) == 0 ? editor.remove_point(c, p) : editor.reverse_curve(c);
      default:
        return below(3) == 0 ? editor.remove_curve(c) : editor.set_closed(c, below(2) == 0);
    }
  }

  void edit_own(editing::Editor& editor, std::size_t c) {
    switch (below(5)) {
      case 0:
        return editor.set_curve_tau(c, below(3) == 0 ? std::nullopt : std::optional(number()));
      case 1:
        return editor.set_curve_tolerance(c,
                                          below(3) == 0 ? std::nullopt : std::optional(number()));
      case 2:
        return editor.pin_curve(c, below(2) == 0);
      case 3:
        return editor.rename_curve(c, std::to_string(below(9)));
      default:
        return editor.continue_curve(c);
    }
  }

  void edit_settings(editing::Editor& editor, std::uint32_t kind) {
    switch (kind) {
      case 15:
        return editor.set_tau(number());
      case 16:
        return editor.set_slack(below(3) == 0 ? std::nullopt : std::optional(number()));
      case 17:
        return editor.set_max_deviation(below(3) == 0 ? std::nullopt : std::optional(number()));
      case 18:
        if (below(10) == 0) return editor.clear();
        return editor.add_curve({{point(), point(), point()}, below(2) == 0});
      default:
        return below(4) == 0 ? editor.drop_curve() : editor.add_point(point());
    }
  }

  std::mt19937 random_;
  std::uint32_t faces_;
};

}  // namespace talweg::test
