#include "CurveRows.hh"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "CurveColours.hh"
#include "Report.hh"
#include "ResultTable.hh"

namespace talweg::openflipper {
namespace {

struct Rows {
  Q_DECLARE_TR_FUNCTIONS(Rows)
};

QString default_title(const editing::Curve& curve) {
  return Rows::tr("Curve %1").arg(curve.number);
}

CurveRow row_of_curve(const Session& session, const editing::Curve& curve) {
  CurveRow row;
  row.number = curve.number;
  const ACG::Vec4f colour = colour_of_curve(curve.number);
  row.colour = QColor::fromRgbF(colour[0], colour[1], colour[2]);
  row.name = QString::fromStdString(curve.name);
  row.title = default_title(curve);
  const std::optional<std::size_t> result = session.result_of(curve.number);
  if (!result) return row;
  const auto value = [&](const char* key) {
    return session.results().number(key, static_cast<int>(*result), std::nan(""));
  };
  row.length = three_digits(value("length_after"));
  row.deviation = farthest_apart(session.results(), static_cast<int>(*result));
  row.warning = decisive_sentences(session.results(), static_cast<int>(*result)).join('\n');
  const double degrees = 180 / M_PI * value("curvature_after");
  row.turning = three_digits_of_degrees(degrees) + QString::fromUtf8("°");
  return row;
}

bool all_pinned(const editing::Curve& curve) {
  return std::all_of(curve.points.begin(), curve.points.end(),
                     [](const editing::Point& point) { return point.pinned; });
}

}  // namespace

QString title_of(const editing::Curve& curve) {
  return curve.name.empty() ? default_title(curve) : QString::fromStdString(curve.name);
}

CurvesState curves_state(const Session& session) {
  const editing::Drawing& drawing = session.editor().drawing();
  CurvesState state;
  for (const auto& curve : drawing.curves) state.rows.push_back(row_of_curve(session, *curve));
  state.unfinished = drawing.unfinished;
  state.general_tau = drawing.settings.tau;
  state.most = session.diagonal() / 40;
  const std::optional<std::size_t> selected = session.selected();
  if (!selected) return state;
  const editing::Curve& curve = *drawing.curves[*selected];
  state.selected = curve.number;
  state.closed = curve.closed;
  state.pinned = all_pinned(curve);
  state.tau = curve.tau;
  state.tolerance = curve.tolerance;
  // The tolerance of a stroke begins with the slack of the result, so that the tick alone changes
  // nothing.
  const double slack = std::max(session.results().number("slack"), 0.0);
  state.general_tolerance =
      editing::all_clicked(curve) ? 0 : drawing.settings.slack.value_or(slack);
  return state;
}

}  // namespace talweg::openflipper
