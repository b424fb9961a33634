#include "app/panels/inspector/rows/rewet_rows.h"

#include "app/session/editor.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "app/widgets/numbers/time_text.h"
#include "undo/time_edits.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QToolButton>

#include <map>

namespace suffuse {

namespace {
constexpr std::size_t mostRows = 8;
}

RewetRows::RewetRows(Editor &editor, QWidget *parent) : QWidget(parent), m_editor(editor)
{
    m_column = new QVBoxLayout(this);
    m_column->setContentsMargins(0, 0, 0, 0);
    hide();
}

void RewetRows::refresh(const Inspected &inspected)
{
    // number of segments by time and length of the wetting
    std::map<std::pair<Microseconds, Microseconds>, std::size_t> counts;
    for (const InspectedSegment &s : inspected.segments)
        for (const Rewet &r : s.segment->rewet)
            ++counts[{r.time, r.extra}];
    std::vector<Row> rows;
    for (const auto &[rewet, count] : counts)
        if (rows.size() < mostRows)
            rows.push_back({{rewet.first, rewet.second}, count >= inspected.segments.size()});
    const bool more = counts.size() > rows.size();
    if (rows != m_rows || more != m_more)
        show(rows, more);
}

void RewetRows::show(const std::vector<Row> &rows, bool more)
{
    m_rows = rows;
    m_more = more;
    if (m_list)
        m_list->deleteLater(); // The button that was pressed may stand in the list, so it is deleted later.
    m_list = new QWidget(this);
    auto *column = new QVBoxLayout(m_list);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(0);
    column->addWidget(sectionTitle(tr("Wetted again"), m_list));
    m_column->addWidget(m_list);
    for (const Row &row : rows)
        addRow(row);
    if (more)
        column->addWidget(quietLabel(tr("… and more"), m_list));
    setVisible(!rows.empty());
}

void RewetRows::addRow(const Row &row)
{
    auto *line = new QHBoxLayout;
    const QString at = clockText(row.rewet.time);
    const QString seconds = QLocale().toString(toSeconds(row.rewet.extra), 'g', 4);
    QLabel *label = quietLabel(row.ofAll ? tr("at %1 for %2 s").arg(at, seconds)
                                         : tr("at %1 for %2 s, some segments").arg(at, seconds),
                               m_list);
    line->addWidget(label, 1);
    auto *remove = new QToolButton(m_list);
    remove->setIcon(icon("delete"));
    remove->setAutoRaise(true);
    remove->setToolTip(tr("The selected paint is not wetted then"));
    remove->setAccessibleName(tr("Remove re-wetting"));
    connect(remove, &QToolButton::clicked, this, [this, rewet = row.rewet] {
        m_editor.push(removeRewetting(m_editor.document(), rewet), tr("Remove re-wetting"));
    });
    line->addWidget(remove);
    static_cast<QVBoxLayout *>(m_list->layout())->addLayout(line);
}

} // namespace suffuse
