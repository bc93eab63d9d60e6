#include "editor_calls.hpp"

#include <map>
#include <vector>

#include "drawing_json.hpp"
#include "talweg/editing/legs.hpp"

namespace talweg::browser {
namespace {

using editing::Editor;
using Arguments = const Json&;
using Call = Json (*)(Editor&, Arguments);

std::size_t index(Arguments a, std::size_t k) { return a.at(k).get<std::size_t>(); }

/// Makes an edit without an answer.
template <class Edit>
Json done(Edit&& edit) {
  edit();
  return nullptr;
}

Json name_or_null(const std::string& name) { return name.empty() ? Json(nullptr) : Json(name); }

/// The name of the step that was undone, or null if there was none.
Json undo(Editor& editor) {
  const std::string name = editor.history().undo_name();
  return editor.history().undo() ? name_or_null(name) : Json(nullptr);
}

Json redo(Editor& editor) {
  const std::string name = editor.history().redo_name();
  return editor.history().redo() ? name_or_null(name) : Json(nullptr);
}

std::vector<editing::Vector> vectors_of(Arguments numbers) {
  std::vector<editing::Vector> result;
  for (std::size_t k = 0; k + 2 < numbers.size(); k += 3) {
    result.push_back(
        {numbers[k].get<double>(), numbers[k + 1].get<double>(), numbers[k + 2].get<double>()});
  }
  return result;
}

const std::map<std::string, Call>& calls_of_drawing() {
  static const std::map<std::string, Call> kCalls = {
      {"drawing", [](Editor& e, Arguments) { return json_of(e.drawing()); }},
      {"isDrawing", [](Editor& e, Arguments) -> Json { return e.is_drawing(); }},
      {"addPoint",
       [](Editor& e, Arguments a) { return done([&] { e.add_point(point_of(a.at(0))); }); }},
      {"paintPoint",
       [](Editor& e, Arguments a) { return done([&] { e.paint_point(point_of(a.at(0))); }); }},
      {"takeBackPoint", [](Editor& e, Arguments) { return done([&] { e.take_back_point(); }); }},
      {"finishCurve", [](Editor& e, Arguments) { return done([&] { e.finish_curve(); }); }},
      {"closeCurve", [](Editor& e, Arguments) { return done([&] { e.close_curve(); }); }},
      {"dropCurve", [](Editor& e, Arguments) { return done([&] { e.drop_curve(); }); }},
      {"undo", [](Editor& e, Arguments) { return undo(e); }},
      {"redo", [](Editor& e, Arguments) { return redo(e); }},
      {"undoName", [](Editor& e, Arguments) { return name_or_null(e.history().undo_name()); }},
      {"redoName", [](Editor& e, Arguments) { return name_or_null(e.history().redo_name()); }},
      {"beginGesture",
       [](Editor& e, Arguments a) {
         return done([&] { e.history().begin_gesture(a.at(0).get<std::string>()); });
       }},
      {"endGesture", [](Editor& e, Arguments) { return done([&] { e.history().end_gesture(); }); }},
      {"restore",
       [](Editor& e, Arguments a) { return done([&] { e = Editor(drawing_of(a.at(0))); }); }},
      {"legAt", [](Editor&, Arguments a) -> Json {
         return editing::leg_at(vectors_of(a.at(0)), vectors_of(a.at(1)), a.at(2).get<bool>(),
                                index(a, 3));
       }}};
  return kCalls;
}

const std::map<std::string, Call>& calls_of_curves() {
  static const std::map<std::string, Call> kCalls = {
      {"removeCurve",
       [](Editor& e, Arguments a) { return done([&] { e.remove_curve(index(a, 0)); }); }},
      {"addCurve",
       [](Editor& e, Arguments a) { return done([&] { e.add_curve(curve_of(a.at(0))); }); }},
      {"setClosed",
       [](Editor& e, Arguments a) {
         return done([&] { e.set_closed(index(a, 0), a.at(1).get<bool>()); });
       }},
      {"reverseCurve",
       [](Editor& e, Arguments a) { return done([&] { e.reverse_curve(index(a, 0)); }); }},
      {"continueCurve",
       [](Editor& e, Arguments a) { return done([&] { e.continue_curve(index(a, 0)); }); }},
      {"clear", [](Editor& e, Arguments) { return done([&] { e.clear(); }); }},
      {"renameCurve",
       [](Editor& e, Arguments a) {
         return done([&] { e.rename_curve(index(a, 0), a.at(1).get<std::string>()); });
       }},
      {"setCurveTau",
       [](Editor& e, Arguments a) {
         return done([&] { e.set_curve_tau(index(a, 0), optional_of(a.at(1))); });
       }},
      {"setCurveTolerance",
       [](Editor& e, Arguments a) {
         return done([&] { e.set_curve_tolerance(index(a, 0), optional_of(a.at(1))); });
       }},
      {"pinCurve",
       [](Editor& e, Arguments a) {
         return done([&] { e.pin_curve(index(a, 0), a.at(1).get<bool>()); });
       }},
      {"movePoint",
       [](Editor& e, Arguments a) {
         return done([&] { e.move_point(index(a, 0), index(a, 1), point_of(a.at(2))); });
       }},
      {"insertPoint",
       [](Editor& e, Arguments a) {
         return done([&] { e.insert_point(index(a, 0), index(a, 1), point_of(a.at(2))); });
       }},
      {"removePoint",
       [](Editor& e, Arguments a) {
         return done([&] { e.remove_point(index(a, 0), index(a, 1)); });
       }},
      {"setPinned",
       [](Editor& e, Arguments a) {
         return done([&] { e.set_pinned(index(a, 0), index(a, 1), a.at(2).get<bool>()); });
       }},
      {"setTau",
       [](Editor& e, Arguments a) { return done([&] { e.set_tau(a.at(0).get<double>()); }); }},
      {"setSlack",
       [](Editor& e, Arguments a) { return done([&] { e.set_slack(optional_of(a.at(0))); }); }},
      {"setPaper",
       [](Editor& e, Arguments a) { return done([&] { e.set_paper(a.at(0).get<bool>()); }); }},
      {"setEnds",
       [](Editor& e, Arguments a) {
         return done([&] { e.set_ends(editing::ends_named(a.at(0).get<std::string>())); });
       }},
      {"setClickDistance",
       [](Editor& e, Arguments a) {
         return done([&] { e.set_click_distance(optional_of(a.at(0))); });
       }},
      {"setRidges",
       [](Editor& e, Arguments a) { return done([&] { e.set_ridges(a.at(0).get<double>()); }); }},
      {"setRidgeKind",
       [](Editor& e, Arguments a) {
         return done([&] { e.set_ridge_kind(editing::ridges_named(a.at(0).get<std::string>())); });
       }},
      {"setOffset",
       [](Editor& e, Arguments a) { return done([&] { e.set_offset(offset_of(a.at(0))); }); }},
      {"setMaxDeviation", [](Editor& e, Arguments a) {
         return done([&] { e.set_max_deviation(optional_of(a.at(0))); });
       }}};
  return kCalls;
}

}  // namespace

Answer call_editor(Editor& editor, const std::string& name, const Json& arguments) {
  Answer answer;
  for (const auto* calls : {&calls_of_drawing(), &calls_of_curves()}) {
    const auto call = calls->find(name);
    if (call == calls->end()) continue;
    answer.json = call->second(editor, arguments);
    return answer;
  }
  throw editing::Error("The editor has no " + name + ".");
}

}  // namespace talweg::browser
