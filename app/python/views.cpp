#include "app/python/views.h"

namespace suffuse::python {

namespace {

const std::vector<const char *> viewOptions{"size", "scale", "area", "time"},
    rendererOptionNames{"backend", "threads", "devices"};

QString sizeText(const py::object &size)
{
    const auto number = [](const py::handle &value) { return py::str(value).cast<QString>(); };
    if (!py::isinstance<py::sequence>(size) || py::isinstance<py::str>(size))
        return number(size);
    QStringList parts;
    for (const py::handle value : size)
        parts.append(number(value));
    return parts.join(QLatin1Char('x'));
}

} // namespace

Asked::Asked(const char *command, const std::vector<const char *> &options) : m_line(QLatin1String(command), {}, {})
{
    m_arguments << QStringLiteral("suffuse") << QLatin1String(command);
    for (const char *option : options)
        m_line.add({QLatin1String(option)}, {}, QStringLiteral("VALUE"));
}

void Asked::set(const char *option, const QString &value)
{
    m_arguments.append(QStringLiteral("--%1=%2").arg(QLatin1String(option), value));
}

void Asked::set(const char *option, const py::object &value)
{
    if (value.is_none())
        return;
    // The shortest text that reads back to the same number.
    set(option, py::isinstance<py::float_>(value)
                    ? QString::number(value.cast<double>(), 'g', QLocale::FloatingPointShortest)
                    : py::str(value).cast<QString>());
}

void Asked::set(const char *option)
{
    m_line.add({QLatin1String(option)}, {});
    m_arguments.append(QStringLiteral("--%1").arg(QLatin1String(option)));
}

void Asked::set(const ViewWish &wish)
{
    if (!wish.size.is_none())
        set("size", sizeText(wish.size));
    if (wish.scale)
        set("scale", py::object(py::float_(*wish.scale)));
    if (wish.area) {
        QStringList parts;
        for (const double v : *wish.area)
            parts.append(QString::number(v, 'g', QLocale::FloatingPointShortest));
        set("area", parts.join(QLatin1Char(',')));
    }
    if (wish.time)
        set("time", py::object(py::float_(*wish.time)));
}

void Asked::set(const QString &backend, int threads, const py::object &devices)
{
    set("backend", backend);
    if (threads != 0)
        set("threads", QString::number(threads));
    set("devices", devices);
}

const cli::CommandLine &Asked::line()
{
    if (m_line.parse(m_arguments))
        raise(Raised::Plain, QStringLiteral("the options could not be understood"));
    return m_line;
}

cli::PictureOptions pictureOptionsOf(const ViewWish &wish, const Painting &painting)
{
    Asked asked("render", viewOptions);
    asked.set(wish);
    return valueOf(cli::pictureOptions(asked.line(), painting), Raised::Value);
}

Microseconds momentOf(std::optional<double> time, const Painting &painting)
{
    Asked asked("render", viewOptions);
    asked.set({py::none(), {}, {}, time});
    return valueOf(cli::timeOption(asked.line(), painting), Raised::Value);
}

RendererOptions rendererOptionsOf(const QString &backend, int threads, const py::object &devices)
{
    Asked asked("render", rendererOptionNames);
    asked.set(backend, threads, devices);
    return valueOf(cli::rendererOptions(asked.line()), Raised::Value);
}

} // namespace suffuse::python
