#include "app/panels/reference/reference_panel.h"

#include "app/panels/reference/reference_view.h"
#include "app/session/colour/colour_target.h"
#include "app/session/colour_convert.h"
#include "app/session/editor.h"
#include "app/session/files/picture_file.h"
#include "app/session/files/underlay_image.h"
#include "app/session/settings/settings.h"
#include "app/widgets/asking/choose_picture.h"
#include "app/widgets/look/section.h"

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMimeData>
#include <QToolButton>
#include <QVBoxLayout>

namespace suffuse {

namespace {

QString referenceKey()
{
    return QStringLiteral("reference/path");
}

QString firstFile(const QMimeData &data)
{
    for (const QUrl &url : data.urls())
        if (url.isLocalFile())
            return url.toLocalFile();
    return {};
}

} // namespace

ReferencePanel::ReferencePanel(Editor &editor, std::function<bool()> picks, QWidget *parent)
    : QWidget(parent), m_editor(editor)
{
    setAcceptDrops(true);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    m_view = new ReferenceView(this);
    m_view->setObjectName("referenceView");
    m_view->setPicks(std::move(picks));
    connect(m_view, &ReferenceView::picked, this,
            [this](const QColor &colour) { m_editor.colourTarget().take(fromScreen(colour)); });
    column->addWidget(m_view, 1);
    m_message = quietLabel({}, this);
    m_message->hide();
    column->addWidget(m_message);
    auto *row = new QHBoxLayout;
    const auto add = [&](const char *name, const QString &text, const QString &tip) {
        auto *button = new QToolButton(this);
        button->setObjectName(QLatin1String(name));
        button->setText(text);
        button->setToolTip(tip);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
        return button;
    };
    QToolButton *choose = add("referenceOpen", tr("Open…"), tr("Choose a picture to look at while painting"));
    m_fit = add("referenceFit", tr("Fit"), tr("Show all of the picture"));
    m_whole = add("reference100", tr("100 %"), tr("A pixel of the picture is one of the screen"));
    m_whole->setAccessibleName(tr("Actual pixels"));
    row->addStretch();
    m_clear = add("referenceClear", tr("Remove"), tr("Show no picture here; its file stays"));
    column->addLayout(row);
    connect(choose, &QToolButton::clicked, this, &ReferencePanel::choose);
    connect(m_fit, &QToolButton::clicked, m_view, &ReferenceView::fit);
    connect(m_whole, &QToolButton::clicked, this, [this] {
        const double whole = 1 / m_view->devicePixelRatioF();
        m_view->zoomBy(whole / m_view->scale(), QPointF(m_view->width() / 2.0, m_view->height() / 2.0));
    });
    connect(m_clear, &QToolButton::clicked, this, &ReferencePanel::clear);
    refresh();
}

void ReferencePanel::refresh()
{
    const bool any = !m_view->picture().isNull();
    for (QToolButton *button : {m_fit, m_whole, m_clear})
        button->setEnabled(any);
}

void ReferencePanel::show(const QImage &picture, const QString &path)
{
    m_isRead = true;
    m_message->hide();
    m_view->setPicture(picture);
    if (path.isEmpty())
        settings::store().remove(referenceKey());
    else
        settings::store().setValue(referenceKey(), path);
    refresh();
}

bool ReferencePanel::open(const QString &path)
{
    const Result<EncodedImage> bytes = readPictureFile(path);
    const Result<UnderlayImagePtr> image =
        bytes ? decodeUnderlay(*bytes, QFileInfo(path).fileName()) : Result<UnderlayImagePtr>(Error{bytes.error()});
    if (!image) {
        m_message->setText(image.error());
        m_message->show();
        return false;
    }
    show((*image)->levels.front(), QFileInfo(path).absoluteFilePath());
    return true;
}

void ReferencePanel::choose()
{
    if (const QString path = choosePicture(this, tr("Open Reference Picture")); !path.isEmpty())
        open(path);
}

void ReferencePanel::clear()
{
    show({}, {});
}

/// The file of last time is read when somebody sees the panel.
void ReferencePanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    if (std::exchange(m_isRead, true))
        return;
    if (const QString path = settings::store().value(referenceKey()).toString(); QFileInfo::exists(path))
        open(path);
}

void ReferencePanel::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasImage() || !firstFile(*event->mimeData()).isEmpty())
        event->acceptProposedAction();
}

void ReferencePanel::dropEvent(QDropEvent *event)
{
    event->acceptProposedAction();
    if (const QString path = firstFile(*event->mimeData()); !path.isEmpty())
        open(path);
    else if (const QImage image = qvariant_cast<QImage>(event->mimeData()->imageData()); !image.isNull())
        show(image, {});
}

} // namespace suffuse
