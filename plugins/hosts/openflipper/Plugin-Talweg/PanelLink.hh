// The panel link carries what a person does in the panel to the drawings, and shows them there.
#pragma once

#include <QObject>

#include "DrawingHand.hh"
#include "TalwegPanel.hh"

namespace talweg::openflipper {

class PanelLink : public QObject {
  Q_OBJECT
 public:
  PanelLink(Sessions& sessions, DrawingHand& hand, HostCalls& host);

  /// It becomes the host's, which shows it.
  [[nodiscard]] TalwegPanel* panel() const { return panel_; }
  /// How the drawing is that is worked on. `hint`: what a click would do.
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
  static QString kinds();  // of files
  void read();
  void write(bool result);

  Sessions& sessions_;
  DrawingHand& hand_;
  HostCalls& host_;
  TalwegPanel* panel_ = new TalwegPanel;
};

}  // namespace talweg::openflipper
