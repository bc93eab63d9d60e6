#include "Report.hh"

#include <QCoreApplication>
#include <cmath>

#include "Session.hh"

namespace talweg::openflipper {
namespace {

QString in_words(const std::string& text) { return QString::fromStdString(text); }

struct Report {
  Q_DECLARE_TR_FUNCTIONS(Report)
};

double degrees(double radians) { return radians * 180 / M_PI; }

QString number(double value) {
  return std::isfinite(value) ? QString::number(value, 'g', 6) : QString("no bound");
}

}  // namespace

QString length_unit() { return Report::tr("units"); }
QString curvature_unit() { return Report::tr("1/unit"); }

QString short_report(const Session& session) {
  const host::Results& r = session.results();
  QStringList lines;
  lines << QString("%1 curve(s), tau %2, slack %3")
               .arg(r.curves.size())
               .arg(number(r.number("tau")))
               .arg(number(r.number("slack")));
  lines << QString("length %1 -> %2")
               .arg(number(r.number("length_before")))
               .arg(number(r.number("length_after")));
  lines << QString("curvature %1 -> %2")
               .arg(number(r.number("curvature_before")))
               .arg(number(r.number("curvature_after")));
  lines << QString("bending %1 -> %2")
               .arg(number(r.number("bending_before")))
               .arg(number(r.number("bending_after")));
  lines << QString("turn in one edge %1 -> %2 degrees")
               .arg(degrees(r.number("window_turning_before")), 0, 'f', 0)
               .arg(degrees(r.number("window_turning_after")), 0, 'f', 0);
  if (r.text("deviation") == "none") {
    lines << "deviation: when the hand rests";
  } else {
    lines << QString("deviation at most %1 (result), %2 (drawing), farthest %3")
                 .arg(number(r.number("deviation_to_drawn_max")))
                 .arg(number(r.number("deviation_from_drawn_max")))
                 .arg(farthest_apart(r, -1));
  }
  lines << QString("%1, %2 ms")
               .arg(in_words(r.text("termination")))
               .arg(session.last_run_ms(), 0, 'f', 1);
  lines << result_notes(session);
  return lines.join(", ");
}

std::vector<ResultRow> result_rows(const Session& session) {
  const host::Results& r = session.results();
  if (r.curves.empty()) return {};
  const QString length = length_unit(), angle = QString::fromUtf8("°");
  const auto row = [&](const QString& what, const char* key, double scale, const QString& unit,
                       const QString& tip) {
    const auto at = [&](const char* end) {
      const double number = scale * r.number(std::string(key) + end, -1, std::nan(""));
      return unit == angle ? three_digits_of_degrees(number) : three_digits(number);
    };
    return ResultRow{what, at("_before"), at("_after"), unit, tip};
  };
  const double degree = 180 / M_PI;
  std::vector<ResultRow> rows = {
      row(Report::tr("Length"), "length", 1, length,
          Report::tr("Of all curves together, in mesh units.")),
      row(Report::tr("Turning"), "curvature", degree, angle,
          Report::tr("The total turning of the curves.")),
      row(Report::tr("Sharpest turn"), "window_turning", degree, angle,
          Report::tr("The most that a curve turns within the length of a mesh edge.")),
      row(Report::tr("Bending"), "bending", 1, curvature_unit(),
          Report::tr("Curvature squared, along the curves."))};
  if (r.text("deviation") != "none") {
    rows.push_back({Report::tr("Deviation"), three_digits(r.number("deviation_from_drawn_max")),
                    three_digits(r.number("deviation_to_drawn_max")), length,
                    Report::tr("How far the drawing gets from the result, and the result from the "
                               "drawing, at most.")});
  }
  return rows;
}

QString result_summary(const Session& session) {
  const host::Results& r = session.results();
  if (r.curves.empty()) return Report::tr("Nothing is smoothed yet.");
  const std::string how = r.text("termination");
  const QString ended = how == "converged"   ? Report::tr("converged")
                        : how == "collapsed" ? Report::tr("a loop collapsed")
                        : how == "limit"     ? Report::tr("stopped at its limit")
                                             : in_words(how);
  return Report::tr("%1 after %2 ms").arg(ended).arg(session.last_run_ms(), 0, 'f', 0);
}

QString result_settings(const Session& session) {
  const host::Results& r = session.results();
  if (r.curves.empty()) return {};
  return Report::tr("tau %1, slack %2")
      .arg(three_digits(r.number("tau")), three_digits(r.number("slack")));
}

QString farthest_apart(const host::Results& results, int curve) {
  const double least = results.number("farthest", curve, std::nan(""));
  const double most = results.number("farthest_at_most", curve, least);
  if (!std::isfinite(least) || most <= least) return three_digits(least);
  if (std::isfinite(most)) return three_digits(least) + " .. " + three_digits(most);
  return QString::fromUtf8("≥ ") + three_digits(least);
}

QStringList decisive_sentences(const host::Results& results, int curve) {
  QStringList sentences;
  if (const host::ReportEntry* decisive = results.find("decisive", curve)) {
    for (const std::string& sentence : decisive->texts) sentences << in_words(sentence);
  }
  return sentences;
}

QStringList result_notes(const Session& session) {
  QStringList notes = decisive_sentences(session.results(), -1);
  if (const host::ReportEntry* warnings = session.results().find("warnings")) {
    for (const std::string& warning : warnings->texts) notes << in_words(warning);
  }
  notes.removeDuplicates();
  return notes;
}

QString whole_report(const Session& session) {
  QStringList lines;
  const host::Results& results = session.results();
  for (const host::ReportEntry& entry : results.report) {
    // With a single curve, entries for all curves repeat the curve's entries.
    const bool said = results.curves.size() == 1 && entry.curve == 0 && results.find(entry.key);
    if (said) continue;
    QStringList values;
    for (const double value : entry.numbers) values << QString::number(value, 'g', 17);
    for (const std::string& text : entry.texts) values << in_words(text);
    const QString key = in_words(entry.key);
    lines << QString("%1 = %2")
                 .arg(entry.curve < 0 ? key : QString("%1.%2").arg(entry.curve).arg(key))
                 .arg(values.join(' '));
  }
  return lines.join('\n');
}

}  // namespace talweg::openflipper
