#include "app/cli/options.h"
#include "model/brush.h"
#include "model/formats/files.h"

#include <QCoreApplication>

namespace suffuse::cli {

int convertCommand(const QStringList &arguments)
{
    CommandLine line("convert",
                     QCoreApplication::translate("Cli",
                                                 "Converts between documents (.suffuse), the text form (.json) and pen "
                                                 "recordings. What IN is, is found from its content; what OUT is, from "
                                                 "its ending."),
                     {"IN", "OUT"});
    line.add({"brush"}, QCoreApplication::translate("Cli", "The brush that recordings are painted with."), "PRESET");
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const QString out = line.argument(1);
    if (formatForSaving(out) == FileFormat::Unknown)
        return failUsage("convert",
                         QCoreApplication::translate("Cli", "%1: unknown ending; use .suffuse or .json").arg(out));
    const Brush *brush = nullptr;
    if (line.isSet("brush")) {
        brush = findBrush(line.value("brush"));
        if (!brush) {
            QStringList names;
            for (const Brush &b : builtinBrushes())
                names.append(b.name);
            return failUsage("convert",
                             QCoreApplication::translate("Cli", "--brush %1: there is no such brush; choose one of %2")
                                 .arg(line.value("brush"), names.join(QStringLiteral(", "))));
        }
    }
    const Result<Painting> painting = loadPainting(line.argument(0), brush);
    if (!painting)
        return fail(painting.error());
    const Result<void> saved = savePainting(*painting, out);
    return saved ? Done : fail(saved.error());
}

} // namespace suffuse::cli
