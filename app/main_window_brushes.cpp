// The favourite brushes: a key each.
#include "app/brush_library.h"
#include "app/main_window.h"

namespace suffuse {

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
    connect(&BrushLibrary::instance(), &BrushLibrary::changed, this, &MainWindow::nameFavourites);
    nameFavourites();
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
