#include "engine.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "drawing_json.hpp"
#include "files.hpp"
#include "inspection.hpp"
#include "label_borders.hpp"
#include "lines.hpp"
#include "mesh_words.hpp"
#include "report_json.hpp"
#include "sample.hpp"
#include "talweg/editing/comb.hpp"
#include "talweg/editing/curve_files.hpp"
#include "talweg/editing/vectors.hpp"

namespace talweg::browser {
namespace {

using editing::MeshArrays;
using editing::Task;

std::vector<float> shown_positions(const std::vector<editing::Vector>& positions) {
  std::vector<float> result;
  result.reserve(3 * positions.size());
  for (const editing::Vector& p : positions) {
    for (const double x : p) result.push_back(static_cast<float>(x));
  }
  return result;
}

std::vector<std::uint32_t> shown_triangles(
    const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::vector<std::uint32_t> result;
  result.reserve(3 * triangles.size());
  for (const auto& t : triangles) result.insert(result.end(), t.begin(), t.end());
  return result;
}

std::string stem_of(const std::string& name) { return name.substr(0, name.rfind('.')); }

[[noreturn]] void fail(const editing::Outcome& outcome) {
  throw host::Error(outcome.status, outcome.sentence);
}

}  // namespace

Answer Engine::open(const std::string& name, std::string_view bytes, bool repair,
                    std::optional<double> weld_within) {
  FileMesh read;
  with_file(name, bytes, [&](const std::string& path) { read = read_mesh(*plugins_, path); });
  *this = Engine(*plugins_);
  mesh_ = std::move(read);
  file_frame_ = mesh_.frame;
  stem_ = stem_of(name);
  mean_edge_ = mean_edge_of(*mesh_.arrays);
  defects_ = repair ? editing::Defects::kRepair : editing::Defects::kRefuse;
  std::optional<WeldOffer> weld;
  if (repair && !weld_within) weld = weld_offer(*plugins_, *mesh_.arrays);
  weld_within_ = weld ? weld->tolerance : weld_within.value_or(0);
  workplace_ = std::make_unique<editing::Workplace>(*plugins_, mesh_.arrays, defects_);
  workplace_->weld_within(weld_within_);
  const editing::Outcome opened = workplace_->work({});
  if (opened.status != TALWEG_OK && opened.status != TALWEG_BAD_MESH) fail(opened);
  const bool usable = opened.status == TALWEG_OK;
  if (!repair && usable) weld = weld_offer(*plugins_, *mesh_.arrays);

  Answer answer;
  answer.json = {{"vertices", mesh_.arrays->positions.size()},
                 {"faces", mesh_.arrays->triangles.size()},
                 {"positions", answer.array(shown_positions(mesh_.arrays->positions))},
                 {"triangles", answer.array(shown_triangles(mesh_.arrays->triangles))},
                 {"size", diagonal_of(*mesh_.arrays)},
                 {"meanEdge", mean_edge_},
                 {"unit", unit_in(mesh_.frame)},
                 {"repair", opened.repair},
                 {"weld", weld ? weld->told : Json(nullptr)},
                 {"repaired", repair && usable ? repair_told(*plugins_, *mesh_.arrays, weld_within_)
                                               : Json(nullptr)},
                 {"defects", opened.sentence.empty() ? Json(nullptr) : Json(opened.sentence)}};
  return answer;
}

Answer Engine::set_unit(const std::string& unit) {
  need_mesh();
  mesh_.frame = unit.empty() ? file_frame_ : with_unit(file_frame_, unit);
  return {};
}

Answer Engine::words() const {
  need_mesh();
  std::string words = mesh_.arrays->triangles.size() > kInspected
                          ? words_of(*mesh_.arrays, mean_edge_)
                          : words_of(inspected(*plugins_, *mesh_.arrays));
  for (const std::string& note : mesh_.left_out) words += "Not read: " + note + ".\n";
  Answer answer;
  answer.json = std::move(words);
  return answer;
}

Answer Engine::sample() const {
  const std::string name = "stone.ply";
  const auto write = [&](const std::string& path) {
    write_mesh(*plugins_, path, sample_mesh(), {});
  };
  Answer answer;
  answer.json = {{"name", name}, {"bytes", answer.array(written(name, write))}};
  return answer;
}

void Engine::need_mesh() const {
  if (!workplace_) throw editing::Error("There is no mesh yet.");
}

editing::Outcome Engine::work(editing::Request request) {
  need_mesh();
  editing::Outcome outcome = workplace_->work(request);
  if (outcome.status != TALWEG_OK) fail(outcome);
  return outcome;
}

Answer Engine::smooth(const editing::Drawing& drawing, const std::string& hand) {
  editing::Request request{Task::kSmooth, 0, drawing};
  request.hand = hand == "drags"    ? editing::Hand::kDrags
                 : hand == "slides" ? editing::Hand::kSlides
                                    : editing::Hand::kRests;
  const bool rests = request.hand == editing::Hand::kRests;
  request.wanted.point_fields = rests;
  smoothed_.reset();
  forget_offsets();
  editing::Outcome outcome = work(std::move(request));
  results_ = std::move(outcome.results);
  last_ = drawing;
  if (rests) smoothed_ = drawing;
  is_cut_ = false;
  Answer answer;
  Json curves = lines_of(results_, 2 * mean_edge_, answer);
  answer.json = {{"curves", std::move(curves)},
                 {"notes", outcome.notes},
                 {"final", rests},
                 {"milliseconds", outcome.milliseconds},
                 {"report", report_json(results_).dump(2)}};
  return answer;
}

Answer Engine::draw(const editing::Drawing& drawing) {
  const editing::Outcome outcome = work({Task::kDraw, 0, drawing});
  Answer answer;
  answer.json = drawn_lines(outcome.results.curves, answer);
  return answer;
}

Answer Engine::leg(const editing::Point& from, const editing::Point& to) {
  editing::Drawing drawing;
  drawing.curves.push_back(std::make_shared<const editing::Curve>(editing::Curve{{from, to}}));
  const editing::Outcome outcome = work({Task::kLeg, 0, drawing});
  Answer answer;
  answer.json = answer.array(flat(outcome.results.curves.at(0).positions));
  return answer;
}

Answer Engine::comb(std::size_t curve, double spacing) const {
  std::vector<editing::Tooth> teeth;
  // During a movement of the hand no curvature is measured.
  if (smoothed_ && curve < results_.curves.size()) {
    teeth = editing::comb_of(*mesh_.arrays, results_.curves[curve], spacing);
  }
  std::vector<editing::Vector> roots, tips;
  std::vector<double> curvature;
  // On a circle as large as the mesh a tooth has a twentieth of the mesh's size.
  const double scale = diagonal_of(*mesh_.arrays) * diagonal_of(*mesh_.arrays) / 40;
  const double longest = diagonal_of(*mesh_.arrays) / 8;
  for (const editing::Tooth& tooth : teeth) {
    roots.push_back(tooth.root);
    const double length = std::min(longest, scale * tooth.curvature);
    tips.push_back(editing::plus(tooth.root, editing::times(length, tooth.out)));
    curvature.push_back(tooth.curvature);
  }
  Answer answer;
  answer.json = {{"roots", answer.array(flat(roots))},
                 {"tips", answer.array(flat(tips))},
                 {"curvature", answer.array(std::move(curvature))}};
  return answer;
}

Answer Engine::offset(const OffsetWish& wish) {
  if (!smoothed_) throw editing::Error("There is no smoothed curve yet.");
  if (!offsets_) {
    offsets_ = std::make_unique<Offsets>(*plugins_, *mesh_.arrays, defects_, weld_within_);
  }
  offsets_->make(results_.curves, wish);
  return offsets_->told();
}

Answer Engine::cut(const editing::Drawing& drawing, bool along_offset) {
  need_mesh();
  const bool is_there =
      smoothed_ && editing::stage_between(*smoothed_, drawing) == editing::Stage::kNothing;
  if (along_offset && (!is_there || !offsets_ || offsets_->curves().empty())) {
    throw editing::Error("There is no offset to cut along.");
  }
  if (!is_there) static_cast<void>(smooth(drawing, "rests"));
  if (results_.curves.empty()) throw editing::Error("There is no smoothed curve to cut along.");
  if (!pieces_) pieces_ = std::make_unique<Pieces>(*plugins_, mesh_, defects_, weld_within_);
  pieces_->cut(along_offset ? offsets_->curves() : results_.curves);
  is_cut_ = true;
  return pieces();
}

Answer Engine::keep(std::size_t part, bool lids) {
  if (!is_cut_) throw editing::Error("The mesh is not cut yet.");
  pieces_->keep(part, lids);
  return pieces();
}

Answer Engine::pieces() const {
  const auto whole = pieces_->together().arrays;
  std::vector<std::int32_t> sides;
  for (std::size_t k = 0; k < pieces_->meshes().size(); ++k) {
    sides.insert(sides.end(), pieces_->meshes()[k].triangles.size(), static_cast<std::int32_t>(k));
  }
  Answer answer;
  answer.json = {{"positions", answer.array(shown_positions(whole->positions))},
                 {"triangles", answer.array(shown_triangles(whole->triangles))},
                 {"side", answer.array(std::move(sides))},
                 {"parts", pieces_->meshes().size()},
                 {"notes", pieces_->notes()}};
  return answer;
}

Answer Engine::labels(std::optional<std::vector<double>> values) const {
  need_mesh();
  Answer answer;
  answer.json = Json::array();
  const std::vector<double> labels = values ? std::move(*values) : labels_of(mesh_);
  for (const editing::Curve& curve : label_borders(*mesh_.arrays, labels)) {
    answer.json.push_back(json_of(curve));
  }
  return answer;
}

Answer Engine::save_curves(const std::string& format, const std::string& what) const {
  need_mesh();
  const bool drawn = format.rfind("drawn.", 0) == 0, offset = what == "offset";
  if (offset && (!offsets_ || offsets_->curves().empty())) {
    throw editing::Error("There is no offset yet.");
  }
  if (!drawn && results_.curves.empty()) throw editing::Error("There is no smoothed curve yet.");
  const std::string name = stem_ + "-" + (drawn ? "" : what + ".") + format;
  const std::vector<host::Curve> curves = drawn    ? editing::drawn_curves(*mesh_.arrays, last_)
                                          : offset ? offsets_->curves()
                                                   : results_.curves;
  Answer answer;
  const auto write = [&](const std::string& path) {
    editing::write_curves(*plugins_, path, *mesh_.arrays, curves, mesh_.frame);
  };
  answer.json = {{"name", name}, {"bytes", answer.array(written(name, write))}};
  return answer;
}

Answer Engine::save_mesh(const std::string& format) const {
  need_mesh();
  const std::string name = stem_ + (is_cut_ ? "-cut." : ".") + format;
  const FileMesh mesh = is_cut_ ? pieces_->together() : mesh_;
  Answer answer;
  const auto write = [&](const std::string& path) {
    write_mesh(*plugins_, path, *mesh.arrays, mesh.attributes, mesh_.frame);
  };
  answer.json = {{"name", name}, {"bytes", answer.array(written(name, write))}};
  return answer;
}

Answer Engine::save_parts(const std::string& format, bool lids) {
  if (!is_cut_) throw editing::Error("The mesh is not cut yet.");
  Answer answer;
  answer.json = Json::array();
  for (const FileMesh& part : pieces_->each(lids)) {
    const std::string name =
        stem_ + "-part-" + std::to_string(answer.json.size() + 1) + "." + format;
    const auto write = [&](const std::string& path) {
      write_mesh(*plugins_, path, *part.arrays, part.attributes, mesh_.frame);
    };
    answer.json.push_back({{"name", name}, {"bytes", answer.array(written(name, write))}});
  }
  return answer;
}

Answer Engine::read_curves(const std::string& name, std::string_view bytes) {
  editing::Request request{Task::kPlace};
  with_file(name, bytes, [&](const std::string& path) {
    request.curves = editing::read_curves(*plugins_, path, *mesh_.arrays, mesh_.frame);
  });
  Answer answer;
  answer.json = Json::array();
  for (const editing::Curve& curve : work(std::move(request)).placed) {
    answer.json.push_back(json_of(curve));
  }
  return answer;
}

}  // namespace talweg::browser
