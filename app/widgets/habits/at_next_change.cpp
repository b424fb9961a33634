#include "app/widgets/habits/at_next_change.h"

#include "model/document/document.h"

#include <QStatusBar>

namespace suffuse {

void atNextChange(const Document &document, QObject *context, std::function<void()> then)
{
    QObject::connect(&document, &Document::changed, context, std::move(then), Qt::SingleShotConnection);
}

void sayUntilChange(QStatusBar &bar, const Document &document, const QString &message, int milliseconds)
{
    bar.showMessage(message, milliseconds);
    atNextChange(document, &bar, [&bar, message] {
        if (bar.currentMessage() == message) // leaves a message that was shown since then
            bar.clearMessage();
    });
}

} // namespace suffuse
