// The functions for JavaScript: one function that takes names of calls, with arguments and answers
// in JSON, and memory for bytes beside them (src/engine/module.ts).
#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing_json.hpp"
#include "editor_calls.hpp"
#include "engine.hpp"
#include "linked_plugins.hpp"

namespace talweg::browser {
namespace {

struct State {
  Engine engine{linked_plugins()};
  std::map<std::uint32_t, editing::Editor> editors;
  std::uint32_t editor_numbers = 0;
  std::string bytes;  // beside the arguments of the next call
  Answer answer;
  std::string text;
};

State& state() {
  static State only;
  return only;
}

std::optional<std::vector<double>> labels_in(const Json& a, const std::string& bytes) {
  if (!a.at(0).get<bool>()) return std::nullopt;
  std::vector<double> labels;
  for (std::size_t k = 0; k + 4 <= bytes.size(); k += 4) {
    std::int32_t label = 0;
    bytes.copy(reinterpret_cast<char*>(&label), sizeof label, k);
    labels.push_back(label);
  }
  return labels;
}

Answer call_engine(const std::string& name, const Json& a) {
  Engine& engine = state().engine;
  const std::string bytes = std::exchange(state().bytes, {});
  const auto text = [&](std::size_t k) { return a.at(k).get<std::string>(); };
  // Omitted arguments at the end are false.
  const auto flag = [&](std::size_t k) { return k < a.size() && a.at(k).get<bool>(); };
  if (name == "open") {
    return engine.open(text(0), bytes, flag(1), optional_of(a.size() > 2 ? a.at(2) : Json()));
  }
  if (name == "setUnit") return engine.set_unit(text(0));
  if (name == "words") return engine.words();
  if (name == "sample") return engine.sample();
  if (name == "smooth") return engine.smooth(drawing_of(a.at(0)), text(1));
  if (name == "draw") return engine.draw(drawing_of(a.at(0)));
  if (name == "leg") return engine.leg(point_of(a.at(0)), point_of(a.at(1)));
  if (name == "comb") return engine.comb(a.at(0).get<std::size_t>(), a.at(1).get<double>());
  if (name == "offset") return engine.offset(offset_wish_of(a.at(0)));
  if (name == "cut") return engine.cut(drawing_of(a.at(0)), flag(1));
  if (name == "keep") return engine.keep(a.at(0).get<std::size_t>(), flag(1));
  if (name == "labels") return engine.labels(labels_in(a, bytes));
  if (name == "saveCurves") return engine.save_curves(text(0), a.size() > 1 ? text(1) : "smooth");
  if (name == "saveMesh") return engine.save_mesh(text(0));
  if (name == "saveParts") return engine.save_parts(text(0), flag(1));
  if (name == "readCurves") return engine.read_curves(text(0), bytes);
  throw editing::Error("The engine has no " + name + ".");
}

/// `editor.new` returns a number, by which the editor is called: `editor.1.addPoint`.
Answer call_editors(const std::string& name, const Json& arguments) {
  State& own = state();
  if (name == "new") {
    Answer answer;
    answer.json = ++own.editor_numbers;
    own.editors.try_emplace(own.editor_numbers);
    return answer;
  }
  const std::size_t point = name.find('.');
  const auto number = static_cast<std::uint32_t>(std::stoul(name));
  if (name.substr(point + 1) == "end") {
    own.editors.erase(number);
    return {};
  }
  return call_editor(own.editors.at(number), name.substr(point + 1), arguments);
}

Answer call(const std::string& name, const Json& arguments) {
  constexpr std::string_view kEditor = "editor.";
  if (name.rfind(kEditor, 0) == 0) return call_editors(name.substr(kEditor.size()), arguments);
  return call_engine(name, arguments);
}

Json error_json(talweg_status status, const char* sentence) {
  return {{"error", sentence}, {"status", status}};
}

/// The text of the answer, or of the error.
std::string answered(const char* name, const char* arguments) {
  State& own = state();
  Json text;
  try {
    own.answer = call(name, Json::parse(arguments));
    text = {{"answer", own.answer.json}};
  } catch (const std::bad_alloc&) {
    text = error_json(TALWEG_OUT_OF_MEMORY, "There is not enough memory.");
  } catch (const host::Error& error) {
    text = error_json(error.status(), error.what());
  } catch (const editing::Error& error) {
    text = error_json(TALWEG_BAD_USAGE, error.what());
  } catch (const std::exception& error) {
    text = error_json(TALWEG_INTERNAL, error.what());
  }
  return text.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace
}  // namespace talweg::browser

extern "C" {

/// JSON, valid until the next call: {"answer": ...}, or {"error": a sentence, "status": a
/// talweg_status}.
const char* talweg_call(const char* name, const char* arguments) {
  auto& own = talweg::browser::state();
  own.answer = {};
  own.text = talweg::browser::answered(name, arguments);
  return own.text.c_str();
}

/// Memory for bytes beside the arguments of the next call.
char* talweg_room(std::size_t bytes) {
  auto& own = talweg::browser::state();
  try {
    own.bytes.assign(bytes, 0);
    return own.bytes.data();
  } catch (const std::exception&) {
    return nullptr;
  }
}

/// The arrays of the last answer.
std::uint32_t talweg_array_kind(std::size_t array) {
  return static_cast<std::uint32_t>(talweg::browser::state().answer.arrays().at(array).kind);
}
std::size_t talweg_array_count(std::size_t array) {
  return talweg::browser::state().answer.arrays().at(array).count;
}
const void* talweg_array_data(std::size_t array) {
  return talweg::browser::state().answer.arrays().at(array).data;
}
}
