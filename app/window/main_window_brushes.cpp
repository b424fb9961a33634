// The brush in hand, which is kept.
#include "app/panels/brushes/brush_panel.h"
#include "app/session/settings/settings.h"
#include "app/window/main_window.h"

namespace suffuse {

namespace {

constexpr int brushKeptMs = 500; ///< after its last change: a slider changes it many times a second

} // namespace

void MainWindow::connectBrushes()
{
    connect(findChild<BrushPanel *>(), &BrushPanel::chosen, this, [this] { action(Command::Brush).setChecked(true); });
    m_brushChanged.setSingleShot(true);
    m_brushChanged.setInterval(brushKeptMs);
    connect(&m_editor, &Editor::brushChanged, &m_brushChanged, qOverload<>(&QTimer::start));
    connect(&m_brushChanged, &QTimer::timeout, this, &MainWindow::keepBrush);
}

void MainWindow::keepBrush()
{
    m_brushChanged.stop();
    settings::setBrush(m_editor.brush());
}

} // namespace suffuse
