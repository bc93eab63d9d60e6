// Applies the user's commands in the panel to the drawings, and shows the drawings' state in the
// panel.
#pragma once

#include <QObject>

#include "DrawingHand.hh"
#include "TalwegPanel.hh"

namespace talweg::openflipper {

class PanelLink : public QObject {
  Q_OBJECT
 public:
  PanelLink(Sessions& sessions, DrawingHand& hand, HostCalls& host);

  /// The host takes ownership and shows the panel.
  [[nodiscard]] TalwegPanel* panel() const { return panel_; }
  /// Shows the state of the current drawing. `hint` tells the effect of a click.
  void show(const QString& hint);

 signals:
  void cancel();

 private:
  void connect_drawing();
  void connect_use();
  void connect_settings();
  void connect_curves();
  void connect_look();
  [[nodiscard]] static LookState look_state(const Session& session);
  static void show_session(const Session& session, PanelState& state);
  static void show_results(const Session& session, PanelState& state);
  void from_lines();
  static QString kinds();  // of files, for dialogs
  void read();
  void write(bool result);

  Sessions& sessions_;
  DrawingHand& hand_;
  HostCalls& host_;
  TalwegPanel* panel_ = new TalwegPanel;
};

}  // namespace talweg::openflipper
