// Keys of favourite brushes and of tools.
#include "app/actions.h"

namespace suffuse {

void Actions::addFavourites()
{
    for (int i = 0; i < 9; ++i)
        add(Command(int(Command::Favourite1) + i), tr("Favourite Brush %1").arg(i + 1), "",
            {QKeySequence(Qt::Key_1 + i)});
}

void Actions::addToolKeys()
{
    add(Command::SmallerSize, tr("S&maller Tool Size"), "", {QKeySequence(Qt::Key_BracketLeft)});
    add(Command::LargerSize, tr("La&rger Tool Size"), "", {QKeySequence(Qt::Key_BracketRight)});
    add(Command::LessOpacity, tr("&Less Opacity"), "", {QKeySequence(Qt::Key_BraceLeft)});
    add(Command::MoreOpacity, tr("More &Opacity"), "", {QKeySequence(Qt::Key_BraceRight)});
    add(Command::HoldToPan, tr("Move the Canvas While Held"), "", {QKeySequence(Qt::Key_Space)});
    add(Command::HoldToTurn, tr("Turn the Canvas While Held"), "", {QKeySequence(Qt::Key_R)});
}

QList<FixedKeys> fixedKeys()
{
    const auto arrows = [](Qt::KeyboardModifiers modifiers) {
        QList<QKeySequence> keys;
        for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down})
            keys << QKeySequence(QKeyCombination(modifiers, key));
        return keys;
    };
    // Tab is not among them: it goes to the next stroke only where a tool has one, and hides the docks otherwise.
    return {{Actions::tr("Move the Selection"), arrows({})},
            {Actions::tr("Move the Selection Ten Times as Far"), arrows(Qt::ShiftModifier)},
            {Actions::tr("Move the Selection by One Unit"), arrows(Qt::AltModifier)},
            {Actions::tr("Move the Selection by Ten Units"), arrows(Qt::AltModifier | Qt::ShiftModifier)},
            {Actions::tr("Previous Stroke or Node"), {QKeySequence(Qt::SHIFT | Qt::Key_Tab)}},
            {Actions::tr("Give Up, or Deselect"), {QKeySequence(Qt::Key_Escape)}}};
}

} // namespace suffuse
