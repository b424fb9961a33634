#include "app/dialogs/about_dialog.h"

#include "app/widgets/habits/help_page.h"
#include "app/widgets/look/icons.h"
#include "app/widgets/look/section.h"
#include "render/backends.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QVBoxLayout>

namespace suffuse {

namespace {

/// A line for each backend, "CPU · 2 threads · AVX2", with the reason where one is missing.
QString backendLines()
{
    QStringList lines;
    for (const BackendInfo &info : backends())
        lines << (info.unavailable.isEmpty() ? QStringLiteral("%1 · %2").arg(nameOf(info.backend), info.device)
                                             : QStringLiteral("%1 — %2").arg(nameOf(info.backend), info.unavailable));
    return lines.join('\n');
}

} // namespace

AboutDialog::AboutDialog(QWidget *parent) : QDialog(parent)
{
    setWindowTitle(tr("About Suffuse"));
    setHelpPage(*this, "index");
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(24, 24, 24, 16);
    column->setSpacing(16);
    auto *row = new QHBoxLayout;
    row->setSpacing(16);
    auto *picture = new QLabel(this);
    picture->setPixmap(applicationIcon().pixmap(QSize(64, 64), devicePixelRatioF()));
    picture->setAccessibleName(tr("Icon of Suffuse"));
    row->addWidget(picture, 0, Qt::AlignTop);

    auto *text = new QVBoxLayout;
    text->setSpacing(8);
    auto *name = sectionTitle(tr("Suffuse %1").arg(QStringLiteral(SUFFUSE_VERSION)), this);
    QFont large = name->font();
    large.setPointSizeF(large.pointSizeF() * 1.4);
    name->setFont(large);
    text->addWidget(name);
    auto *what = new QLabel(tr("Paints with strokes that really diffuse, and stay editable."), this);
    what->setWordWrap(true);
    text->addWidget(what);
    text->addWidget(quietLabel(tr("Free software under the Apache License 2.0."), this));
    auto *builtWith =
        quietLabel(QStringLiteral("Qt %1\n%2").arg(QString::fromLatin1(qVersion()), backendLines()), this);
    builtWith->setTextInteractionFlags(Qt::TextSelectableByMouse);
    text->addWidget(builtWith);
    row->addLayout(text, 1);
    column->addLayout(row);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    column->addWidget(buttons);
    setMinimumWidth(400);
}

} // namespace suffuse
