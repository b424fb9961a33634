#include "app/cli/progress.h"

#include <QCoreApplication>

#include <cmath>
#include <cstdio>

#include <unistd.h>

namespace suffuse::cli {

ProgressLine::ProgressLine(const QString &text, bool withRest)
    : m_text(text.toLocal8Bit()), m_withRest(withRest), m_shown(::isatty(STDERR_FILENO) != 0)
{
    m_clock.start();
}

ProgressLine::~ProgressLine()
{
    if (m_percent >= 0)
        std::fputs("\r\033[K", stderr);
}

void ProgressLine::show(qint64 done, qint64 all)
{
    if (!m_shown || all <= 0)
        return;
    const int percent = int(100 * done / all);
    const std::lock_guard lock(m_mutex);
    if (percent == m_percent || m_clock.elapsed() < 300) // quick work shows nothing
        return;
    m_percent = percent;
    QByteArray line = m_text + ' ' + QByteArray::number(percent) + " %";
    if (m_withRest && done > 0) {
        const int rest = int(std::ceil(double(m_clock.elapsed()) * 1e-3 * double(all - done) / double(done)));
        line += " · " + QCoreApplication::translate("Cli", "%n s left", nullptr, rest).toLocal8Bit();
    }
    std::fprintf(stderr, "\r%s\033[K", line.constData());
    std::fflush(stderr);
}

} // namespace suffuse::cli
