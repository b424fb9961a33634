// The favourite brushes: a key each; and the brush in hand, which is kept.
#include "app/panels/brushes/brush_panel.h"
#include "app/session/settings/brush_library.h"
#include "app/session/settings/settings.h"
#include "app/window/main_window.h"

namespace suffuse {

namespace {

constexpr int brushKeptMs = 500; ///< after its last change: a slider changes it many times a second

} // namespace

void MainWindow::connectBrushes()
{
    for (int i = 0; i < BrushLibrary::keys; ++i)
        connect(&action(Command(int(Command::Favourite1) + i)), &QAction::triggered, this, [this, i] {
            const QStringList names = BrushLibrary::instance().favourites();
            if (i >= names.size())
                return;
            BrushLibrary::instance().use(m_editor, names[i]);
            action(Command::Brush).setChecked(true);
        });
    connect(findChild<BrushPanel *>(), &BrushPanel::chosen, this, [this] { action(Command::Brush).setChecked(true); });
    connect(&BrushLibrary::instance(), &BrushLibrary::changed, this, &MainWindow::nameFavourites);
    nameFavourites();
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

void MainWindow::nameFavourites()
{
    const QStringList names = BrushLibrary::instance().favourites();
    for (int i = 0; i < BrushLibrary::keys; ++i) {
        QAction &favourite = action(Command(int(Command::Favourite1) + i));
        favourite.setVisible(i < names.size());
        if (i < names.size())
            favourite.setText(brushTitle(names[i]).replace('&', QStringLiteral("&&")));
    }
}

} // namespace suffuse
