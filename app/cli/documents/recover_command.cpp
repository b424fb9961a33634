// What is left of documents whose editor ended without closing them.
#include "app/cli/options.h"
#include "model/formats/files.h"
#include "model/journal/recovery.h"

#include <QCoreApplication>
#include <QJsonArray>

#include <algorithm>

namespace suffuse::cli {

namespace {

QJsonObject jsonOf(const LostDocument &document)
{
    const JournalContent &content = document.content;
    return {{"id", document.id()},
            {"state", "lost"},
            {"name", document.name()},
            {"path", content.head.path},
            {"time", document.lastChange().toUTC().toString(Qt::ISODate)},
            {"strokes", qint64(content.painting.strokes.size())},
            {"segments", qint64(content.painting.segmentCount())},
            {"edits", qint64(content.edits)},
            {"bytes", document.file->size()}};
}

QString textOf(const LostDocument &document)
{
    const QString name = document.name().isEmpty() ? QCoreApplication::translate("Cli", "untitled") : document.name();
    return QStringLiteral("%1  %2  %3, %4\n")
        .arg(
            document.id(), document.lastChange().toString(QStringLiteral("yyyy-MM-dd HH:mm:ss")), name,
            QCoreApplication::translate("Cli", "%n stroke(s)", nullptr, int(document.content.painting.strokes.size())));
}

int printList(const Journals &journals, bool json)
{
    QJsonArray list;
    QString text;
    for (const LostDocument &document : journals.lost) {
        list.append(jsonOf(document));
        text += textOf(document);
    }
    const auto others = [&](const std::vector<OtherJournal> &some, const char *state, const QString &said) {
        for (const OtherJournal &journal : some) {
            list.append(QJsonObject{{"id", journal.id}, {"state", state}, {"reason", journal.reason}});
            text += QStringLiteral("%1  %2\n").arg(journal.id, journal.reason.isEmpty() ? said : journal.reason);
        }
    };
    others(journals.inUse, "in use", QCoreApplication::translate("Cli", "in use by a running Suffuse"));
    others(journals.unreadable, "unreadable", {});
    if (json)
        return printJson({{"journals", list}});
    return print(text.isEmpty() ? QCoreApplication::translate("Cli", "There is nothing to recover.\n") : text);
}

} // namespace

int recoverCommand(const QStringList &arguments)
{
    CommandLine line("recover",
                     QCoreApplication::translate("Cli", "Lists what was painted and not saved when Suffuse ended "
                                                        "unexpectedly, or writes one of it to a file."),
                     {"ID"});
    line.add({"list"}, QCoreApplication::translate("Cli", "Lists what there is; the same as no ID."));
    line.add({"o", "output"}, QCoreApplication::translate("Cli", "The file to write: .suffuse or .json."), "OUT");
    line.add({"json"}, QCoreApplication::translate("Cli", "Prints JSON (docs/cli.md)."));
    if (const std::optional<int> code = line.parse(arguments, 0))
        return *code;
    const QString id = line.argument(0);
    const bool json = line.isSet("json");
    if (id.isEmpty() == line.isSet("output") || (line.isSet("list") && !id.isEmpty()))
        return failUsage("recover", QCoreApplication::translate("Cli", "give an ID and -o OUT, or neither"));
    const QString out = line.value("output");
    if (!id.isEmpty() && formatForSaving(out) == FileFormat::Unknown)
        return failUsage("recover",
                         QCoreApplication::translate("Cli", "-o %1: what is recovered is a painting: give a name that "
                                                            "ends in .suffuse or .json. suffuse-cli render draws it "
                                                            "then")
                             .arg(out));
    Journals journals = findJournals(journalFolder());
    if (id.isEmpty())
        return printList(journals, json);
    const auto wanted = std::find_if(journals.lost.begin(), journals.lost.end(),
                                     [&](const LostDocument &document) { return document.id() == id; });
    if (wanted == journals.lost.end())
        return fail(QCoreApplication::translate("Cli",
                                                "%1: there is no such journal to recover. See suffuse-cli recover "
                                                "--list.")
                        .arg(id));
    DocumentExtras extras;
    extras.resolution = wanted->content.head.resolution;
    if (const Result<void> saved = saveDocument(wanted->content.painting, extras, out); !saved)
        return fail(saved.error());
    return json ? printJson(jsonOf(*wanted)) : Done;
}

} // namespace suffuse::cli
