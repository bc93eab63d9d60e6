// What a session tells of its results.
#include <cmath>

#include "Session.hh"

namespace talweg::openflipper {
namespace {

QString in_words(const std::string& text) { return QString::fromStdString(text); }

double degrees(double radians) { return radians * 180 / M_PI; }

QString number(double value) {
  return std::isfinite(value) ? QString::number(value, 'g', 6) : QString("no bound");
}

}  // namespace

QString short_report(const Session& session) {
  const host::Results& r = session.results();
  if (r.curves.empty()) return "Nothing is drawn yet.";
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
    lines << QString("deviation at most %1 (result), %2 (drawing)")
                 .arg(number(r.number("deviation_to_drawn_max")))
                 .arg(number(r.number("deviation_from_drawn_max")));
  }
  lines << QString("%1, %2 ms")
               .arg(in_words(r.text("termination")))
               .arg(session.last_run_ms(), 0, 'f', 1);
  if (const host::ReportEntry* warnings = r.find("warnings")) {
    for (const std::string& warning : warnings->texts) lines << in_words(warning);
  }
  return lines.join('\n');
}

QString whole_report(const Session& session) {
  QStringList lines;
  const host::Results& results = session.results();
  for (const host::ReportEntry& entry : results.report) {
    // Of a single curve the entries for all curves say the same.
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
