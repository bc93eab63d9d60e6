// The look box is the part of the panel that says how curves look: colours with their legend, combs
// and what is marked.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "Legend.hh"

namespace talweg::openflipper {

struct LookState {
  int coloured_by = 0;
  double most = 0;     ///< what the last colour stands for; 0: there are no colours
  QString unit;        ///< of that
  bool points = true;  ///< whether drawn points are shown
  bool comb = false;
  QString comb_text;  ///< its scale
  int mark = 0;
  QString mark_text;  ///< how much is there, and where
};

class LookBox : public QWidget {
  Q_OBJECT
 public:
  explicit LookBox(QWidget* parent);
  void show_state(const LookState& state);

 signals:
  void colour_by(int what);
  void points(bool with);
  void comb(bool with);
  void mark(int what);

 private:
  QComboBox *colours_, *marks_;
  QCheckBox *points_, *comb_;
  QLabel *comb_text_, *mark_text_;
  Legend* legend_;
};

}  // namespace talweg::openflipper
