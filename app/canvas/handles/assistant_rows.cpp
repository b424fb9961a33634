#include "app/canvas/handles/assistant_rows.h"

#include "app/canvas/canvas_widget.h"
#include "app/session/commands/commands.h"
#include "app/session/drawing_aids.h"
#include "app/session/editor.h"
#include "app/session/settings/settings.h"

namespace suffuse {

void addAssistantRows(Commands &table, CanvasWidget &canvas)
{
    using enum Command;
    DrawingAids &aids = canvas.editor().aids();
    const auto addSwitch = [&](Command command, bool CanvasAids::*aid, const QString &id, const QString &text,
                               const char *icon, const QList<QKeySequence> &keys, const QString &tip) {
        table.add(command, id, text, icon, keys, tip).checkable(canvas.aids().*aid).toggles([&canvas, aid](bool on) {
            CanvasAids now = canvas.aids();
            now.*aid = on;
            canvas.setAids(now);
            settings::setCanvasAids(now);
        });
    };
    addSwitch(ShowAssistants, &CanvasAids::showAssistants, "showAssistants", Commands::tr("S&how the Assistants"),
              "eye", {}, Commands::tr("Nothing is led by those that are not seen"));
    addSwitch(SnapToAssistants, &CanvasAids::snapToAssistants, "snapToAssistants", Commands::tr("&Snap to Assistants"),
              "magnet", {QKeySequence(Commands::tr("Shift+L"))},
              Commands::tr("A stroke of the Brush follows the assistant whose direction it begins with"));
    table.add(RemoveAssistants, "removeAssistants", Commands::tr("Remove &All Assistants"), "", {})
        .when([&aids] { return !aids.assistants().empty(); }, Commands::tr("There are no assistants."))
        .runs([&aids] { aids.setAssistants({}); });
    QObject::connect(&aids, &DrawingAids::changed, &table, [&table] { table.update(RemoveAssistants); });
}

} // namespace suffuse
