// ParaView's panel around a widget of it.
#pragma once

class QWidget;

/// Presses its Apply; nothing if the widget is in no panel.
void apply_panel_of(QWidget& widget);
