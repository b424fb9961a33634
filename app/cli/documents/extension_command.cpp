// Extensions without a window: which there are, and running one.
#include "app/cli/options.h"
#include "app/cli/progress.h"
#include "app/cli/stroke_choice.h"
#include "app/extensions/confinement.h"
#include "app/extensions/extension_run.h"
#include "app/extensions/field_values.h"
#include "app/extensions/found_extensions.h"
#include "app/extensions/manifest.h"
#include "model/formats/files.h"
#include "undo/lettering/text_setter.h"
#include "undo/text_links.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QTextStream>

#include <algorithm>

namespace suffuse::cli {

namespace {

const QString english = QStringLiteral("en"); // as all that suffuse-cli says

const char *nameOf(ExtensionField::Type type)
{
    static constexpr const char *names[] = {"number", "whole", "choice", "switch", "text", "colour", "file"};
    return names[int(type)];
}

QJsonObject jsonOf(const ExtensionField &field)
{
    QJsonObject json{
        {"id", field.id}, {"type", nameOf(field.type)}, {"label", field.label.in(english)}, {"default", field.usual}};
    if (field.type == ExtensionField::Type::Number || field.type == ExtensionField::Type::Whole) {
        json["least"] = field.least;
        json["most"] = field.most;
    }
    QJsonArray choices;
    for (const ExtensionField::Choice &choice : field.choices)
        choices.append(choice.id);
    if (!choices.isEmpty())
        json["choices"] = choices;
    return json;
}

QJsonObject jsonOf(const FoundExtension &found)
{
    QJsonObject json{{"folder", found.folder}, {"own", found.isOwn}, {"problem", found.problem}};
    if (!found.extension)
        return json;
    const Extension &e = *found.extension;
    json["id"] = e.id;
    json["name"] = e.name.in(english);
    json["description"] = e.description.in(english);
    QJsonArray fields;
    for (const ExtensionField &field : e.fields)
        fields.append(jsonOf(field));
    json["fields"] = fields;
    return json;
}

QString textOf(const FoundExtension &found)
{
    if (!found.extension)
        return QCoreApplication::translate("Cli", "%1 cannot be used").arg(found.folder) + QStringLiteral("\n    ") +
               found.problem + '\n';
    const Extension &e = *found.extension;
    QString text = QStringLiteral("%1  %2\n").arg(e.id, -14).arg(e.name.in(english));
    for (const ExtensionField &field : e.fields)
        text += QStringLiteral("    %1=%2  %3\n").arg(field.id, textOfValue(field.usual), field.label.in(english));
    return text;
}

int listCommand(const QStringList &arguments)
{
    CommandLine line("extension list", QCoreApplication::translate("Cli", "Lists the extensions that there are."), {});
    line.add({"json"}, QCoreApplication::translate("Cli", "Prints JSON (docs/cli.md)."));
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const std::vector<FoundExtension> all = findExtensions();
    if (line.isSet("json")) {
        QJsonArray list;
        for (const FoundExtension &found : all)
            list.append(jsonOf(found));
        return printJson({{"extensions", list},
                          {"confined", !confinement().bubblewrap.isEmpty()},
                          {"folder", ownExtensionsFolder()}});
    }
    QString text;
    for (const FoundExtension &found : all)
        text += textOf(found);
    return print(text + confinement().why + '\n');
}

/// By its id, or by the path of its folder.
Result<Extension> extensionNamed(const QString &name)
{
    if (name.contains('/')) {
        const QString path = QFileInfo(name + '/' + manifestName).absoluteFilePath();
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return Error{QCoreApplication::translate("Cli", "%1: cannot be read").arg(path)};
        return readManifest(file.readAll(), path);
    }
    for (const FoundExtension &found : findExtensions())
        if (found.extension && found.extension->id == name)
            return *found.extension;
    return Error{QCoreApplication::translate("Cli", "%1: there is no such extension. See suffuse-cli extension list.")
                     .arg(name)};
}

/// What --set says. The error is a usage error.
Result<QJsonObject> valuesOf(const CommandLine &line, const Extension &extension)
{
    QJsonObject values = usualValues(extension);
    for (const QString &given : line.values("set")) {
        const QString id = given.section('=', 0, 0);
        const ExtensionField *field = fieldOf(extension, id);
        if (!field || !given.contains('=')) {
            QStringList known;
            for (const ExtensionField &f : extension.fields)
                known << f.id;
            return Error{QCoreApplication::translate("Cli", "--set %1: give FIELD=VALUE with one of the fields %2")
                             .arg(given, known.join(QStringLiteral(", ")))};
        }
        const Result<QJsonValue> value = valueOfText(*field, given.section('=', 1));
        if (!value)
            return Error{QStringLiteral("--set %1: %2").arg(given, value.error())};
        values[id] = *value;
    }
    if (const QString problem = problemOfValues(extension, values, english); !problem.isEmpty())
        return Error{QCoreApplication::translate("Cli", "%1; give it by --set").arg(problem)};
    return values;
}

int runOn(const CommandLine &line, const Extension &extension, const QJsonObject &values)
{
    Result<Painting> painting = paintingOf(line.argument(1));
    if (!painting)
        return fail(painting.error());
    ExtensionOrder order;
    order.extension = extension;
    order.values = values;
    order.painting = std::make_shared<const Painting>(std::move(*painting));
    order.time = order.painting->end();
    order.language = english;
    if (line.isSet("select")) {
        const auto ids = strokesNamed(line.value("select"), *order.painting);
        if (!ids)
            return failUsage("extension run", ids.error());
        order.selected = {ids->begin(), ids->end()};
    } else if (extension.passes == Extension::Passes::Selection) {
        for (const StrokePtr &stroke : order.painting->strokes)
            order.selected.insert(stroke->id);
    }
    if (line.isSet("layer")) {
        const Result<GroupId> layer = layerNamed(line.value("layer"), *order.painting);
        if (!layer)
            return failUsage("extension run", layer.error());
        order.layer = *layer;
    }
    ExtensionOutcome outcome;
    {
        ProgressLine progress(extension.name.in(english));
        outcome = runExtension(order, interrupted(),
                               [&](double share, const QString &) { progress.show(qint64(share * 1000), 1000); });
    }
    if (outcome.cancelled)
        return fail(QCoreApplication::translate("Cli", "stopped; nothing was written"));
    if (!outcome.error.isEmpty())
        return fail(outcome.error);
    if (outcome.painting) {
        const Painting made = withTextsCompleted(*order.painting, *outcome.painting, layAsFilesDo);
        if (const Result<void> saved = saveDocument(made, {}, line.value("output")); !saved)
            return fail(saved.error());
    }
    return outcome.said.isEmpty() ? int(Done) : print(outcome.said + '\n');
}

int runCommand(const QStringList &arguments)
{
    CommandLine line(
        "extension run",
        QCoreApplication::translate("Cli", "Runs an extension on a painting, and writes what it makes of it."),
        {"EXTENSION", "IN"});
    line.add({"o", "output"}, QCoreApplication::translate("Cli", "The file to write: .suffuse or .json."), "OUT");
    line.add({"set"}, QCoreApplication::translate("Cli", "A field's value; may be given several times."),
             "FIELD=VALUE");
    line.allowRepeated("set");
    line.add({"select"},
             QCoreApplication::translate("Cli", "The strokes that are selected, by their ids, such as 3,7,20-180."),
             "IDS");
    line.add({"layer"}, QCoreApplication::translate("Cli", "The group that is painted on, by its name."), "NAME");
    if (const std::optional<int> code = line.parse(arguments))
        return *code;
    const Result<Extension> extension = extensionNamed(line.argument(0));
    if (!extension)
        return fail(extension.error());
    const QString out = line.value("output");
    if (extension->returnsPainting && out.isEmpty())
        return failUsage("extension run",
                         QCoreApplication::translate("Cli", "-o OUT is missing: name the file to write"));
    if (!extension->returnsPainting && !out.isEmpty())
        return failUsage("extension run",
                         QCoreApplication::translate("Cli", "%1 makes no painting; leave -o away").arg(extension->id));
    if (!out.isEmpty() && formatForSaving(out) == FileFormat::Unknown)
        return failUsage("extension run",
                         QCoreApplication::translate("Cli", "%1: end the name with .suffuse or .json").arg(out));
    if (!out.isEmpty() && isSameFile(line.argument(1), out))
        return fail(inputWouldBeLost(out));
    const Result<QJsonObject> values = valuesOf(line, *extension);
    if (!values)
        return failUsage("extension run", values.error());
    return runOn(line, *extension, *values);
}

} // namespace

int extensionCommand(const QStringList &arguments)
{
    QString help = QCoreApplication::translate("Cli", "Usage: suffuse-cli extension COMMAND [options] …") + "\n\n";
    help += QStringLiteral("  %1%2\n")
                .arg("list", -10)
                .arg(QCoreApplication::translate("Cli", "the extensions that there are, with their fields"));
    help += QStringLiteral("  %1%2\n")
                .arg("run", -10)
                .arg(QCoreApplication::translate("Cli", "run one on a painting, and write what it makes of it"));
    const QString name = arguments.value(2);
    if (name == "--help" || name == "-h")
        return print(help);
    QStringList own = arguments;
    if (own.size() > 2)
        own.removeAt(1);
    if (name == "list")
        return listCommand(own);
    if (name == "run")
        return runCommand(own);
    if (name.isEmpty()) {
        QTextStream(stderr) << help;
        return WrongUsage;
    }
    return fail(
        QCoreApplication::translate("Cli", "extension %1: there is no such command. See suffuse-cli extension --help.")
            .arg(name),
        WrongUsage);
}

} // namespace suffuse::cli
