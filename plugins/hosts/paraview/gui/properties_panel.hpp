// ParaView's panel that contains a widget.
#pragma once

class QWidget;

/// Presses the panel's Apply button; does nothing if the widget is in no panel.
void apply_panel_of(QWidget& widget);
