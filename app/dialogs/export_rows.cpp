#include "app/dialogs/export_rows.h"

#include "app/dialogs/export_dialog.h"
#include "app/editor.h"
#include "app/settings.h"
#include "render/renderer.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QSpinBox>

#include <algorithm>
#include <cmath>

namespace suffuse {

SizeRow::SizeRow(QGridLayout &grid, int row, int largestSide, QWidget *parent) : QWidget(parent)
{
    auto *label = new QLabel(tr("Size"), parent);
    auto *line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(8);
    m_width = new QSpinBox(this);
    m_height = new QSpinBox(this);
    for (QSpinBox *box : {m_width, m_height}) {
        box->setRange(1, largestSide);
        box->setSuffix(tr(" px"));
        line->addWidget(box);
        if (box == m_width)
            line->addWidget(new QLabel(QStringLiteral("×"), this));
    }
    line->addStretch(1);
    m_width->setAccessibleName(tr("Width in pixels"));
    m_width->setToolTip(tr("Width in pixels; the height follows."));
    m_height->setAccessibleName(tr("Height in pixels"));
    m_height->setToolTip(tr("Height in pixels; the width follows."));
    label->setBuddy(m_width);
    grid.addWidget(label, row, 0);
    grid.addWidget(this, row, 1, 1, 2);
    connect(m_width, &QSpinBox::valueChanged, this, &SizeRow::showHeight);
    connect(m_height, &QSpinBox::editingFinished, this, &SizeRow::takeHeight);
}

void SizeRow::setArea(const Rect &area, double width)
{
    m_area = area;
    m_width->setValue(int(std::clamp(std::round(width), 1.0, double(m_width->maximum()))));
    showHeight();
}

void SizeRow::showHeight()
{
    m_height->setValue(suffuse::heightForWidth(m_area, m_width->value()));
}

void SizeRow::takeHeight()
{
    if (m_height->value() != suffuse::heightForWidth(m_area, m_width->value()))
        m_width->setValue(int(std::lround(m_height->value() * m_area.width() / m_area.height())));
    showHeight();
}

QString suggestedExportPath(const Editor &editor, QStandardPaths::StandardLocation place, const QString &ending)
{
    const QFileInfo document(editor.filePath());
    const bool isNew = editor.filePath().isEmpty();
    QString folder = settings::store().value("exportFolder").toString();
    if (folder.isEmpty() || !QDir(folder).exists())
        folder = isNew ? QStandardPaths::writableLocation(place) : document.absolutePath();
    if (!QDir(folder).exists())
        folder = QDir::homePath();
    const QString name = isNew ? ExportDialog::tr("painting") : document.completeBaseName();
    return QDir(folder).filePath(name + QLatin1Char('.') + ending);
}

} // namespace suffuse
