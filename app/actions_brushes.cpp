// The favourite brushes' keys.
#include "app/actions.h"

namespace suffuse {

void Actions::addFavourites()
{
    for (int i = 0; i < 9; ++i)
        add(Command(int(Command::Favourite1) + i), tr("Favourite Brush %1").arg(i + 1), "",
            {QKeySequence(Qt::Key_1 + i)});
}

} // namespace suffuse
