<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>Bench</name>
    <message>
        <source>stopped before all was measured</source>
        <translation>すべて計測し終える前に中止しました</translation>
    </message>
    <message>
        <source>no temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>一時フォルダーを作成できません: %1。TMPDIR に書き込み可能なフォルダーを設定してください。</translation>
    </message>
    <message>
        <source>there is no stroke to drag in this painting</source>
        <translation>この絵には、ドラッグできるストロークがありません</translation>
    </message>
    <message>
        <source>measuring %1</source>
        <translation>%1 を計測中</translation>
    </message>
    <message>
        <source>name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>compared</source>
        <translation>比較対象</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>絵</translation>
    </message>
    <message>
        <source>size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>backend</source>
        <translation>バックエンド</translation>
    </message>
    <message>
        <source>device</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>median ms</source>
        <translation>中央値 ms</translation>
    </message>
    <message>
        <source>min ms</source>
        <translation>最小 ms</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>回数</translation>
    </message>
    <message>
        <source>ratio</source>
        <translation>比</translation>
    </message>
</context>
<context>
    <name>Brushes</name>
    <message>
        <source>Ink wash</source>
        <translation>薄墨</translation>
    </message>
    <message>
        <source>Watercolour edge</source>
        <translation>水彩境界</translation>
    </message>
    <message>
        <source>Soft airbrush</source>
        <translation>ソフトエアブラシ</translation>
    </message>
    <message>
        <source>Flat marker</source>
        <translation>平マーカー</translation>
    </message>
    <message>
        <source>Dry chalk</source>
        <translation>ドライチョーク</translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation>鉛筆</translation>
    </message>
    <message>
        <source>Brush pen</source>
        <translation>筆ペン</translation>
    </message>
    <message>
        <source>Dry brush</source>
        <translation>ドライブラシ</translation>
    </message>
    <message>
        <source>Ink splash</source>
        <translation>墨しぶき</translation>
    </message>
    <message>
        <source>Broad nib</source>
        <translation>平ペン</translation>
    </message>
    <message>
        <source>Flat wash</source>
        <translation>平塗りウォッシュ</translation>
    </message>
    <message>
        <source>Granulating wash</source>
        <translation>粒状化ウォッシュ</translation>
    </message>
    <message>
        <source>Wet in wet</source>
        <translation>にじみ</translation>
    </message>
    <message>
        <source>Glaze</source>
        <translation>グレーズ</translation>
    </message>
    <message>
        <source>Two tones</source>
        <translation>ツートーン</translation>
    </message>
    <message>
        <source>Charcoal</source>
        <translation>木炭</translation>
    </message>
    <message>
        <source>Pastel</source>
        <translation>パステル</translation>
    </message>
    <message>
        <source>Gouache</source>
        <translation>ガッシュ</translation>
    </message>
    <message>
        <source>Glow</source>
        <translation>発光</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>墨</translation>
    </message>
    <message>
        <source>Watercolour</source>
        <translation>水彩</translation>
    </message>
    <message>
        <source>Dry</source>
        <translation>ドライ</translation>
    </message>
    <message>
        <source>Flat</source>
        <translation>平塗り</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>エアブラシ</translation>
    </message>
    <message>
        <source>Others</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>Round wash</source>
        <translation>丸筆ウォッシュ</translation>
    </message>
</context>
<context>
    <name>Buttons</name>
    <message>
        <source>&amp;OK</source>
        <translation>&amp;OK</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>キャンセル(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>破棄(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>開く(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>はい(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>いいえ(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation>適用(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>リセット(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Retry</source>
        <translation>再試行(&amp;R)</translation>
    </message>
    <message>
        <source>Restore &amp;Defaults</source>
        <translation>既定値に戻す(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Show Details...</source>
        <translation>詳細を表示(&amp;S)…</translation>
    </message>
    <message>
        <source>&amp;Hide Details...</source>
        <translation>詳細を隠す(&amp;H)…</translation>
    </message>
</context>
<context>
    <name>ChoosePicture</name>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Pictures and diffusion curves</source>
        <translation>画像と拡散曲線</translation>
    </message>
</context>
<context>
    <name>Cli</name>
    <message>
        <source>%1: cannot be read (%2). Check the name and its permissions.</source>
        <translation>%1: 読み込めません（%2）。名前とアクセス権を確認してください。</translation>
    </message>
    <message>
        <source>%1: has more than 2 GB; that is more than can be opened</source>
        <translation>%1: 2 GB を超えています。これより大きいファイルは開けません</translation>
    </message>
    <message>
        <source>  bytes     %1</source>
        <translation>  バイト数    %1</translation>
    </message>
    <message>
        <source>  canvas    %1 × %2</source>
        <translation>  キャンバス  %1 × %2</translation>
    </message>
    <message>
        <source>  on paper  %1 × %2 mm, %3 units an inch</source>
        <translation>  印刷サイズ  %1 × %2 mm、1 インチあたり %3 単位</translation>
    </message>
    <message>
        <source>  strokes   %1</source>
        <translation>  ストローク  %1</translation>
    </message>
    <message>
        <source>  segments  %1</source>
        <translation>  セグメント  %1</translation>
    </message>
    <message>
        <source>  bounds    none: nothing is painted</source>
        <translation>  範囲        なし: 何も描かれていません</translation>
    </message>
    <message>
        <source>  bounds    x %1, y %2, %3 × %4</source>
        <translation>  範囲        x %1, y %2, %3 × %4</translation>
    </message>
    <message>
        <source>  duration  %1 s</source>
        <translation>  長さ        %1 s</translation>
    </message>
    <message>
        <source>  chunk     %1, %2 bytes</source>
        <translation>  チャンク    %1, %2 バイト</translation>
    </message>
    <message>
        <source>%1not available: %2</source>
        <translation>%1使用不可: %2</translation>
    </message>
    <message>
        <source>Tells what a painting or a recording holds.</source>
        <translation>絵または記録の内容を表示します。</translation>
    </message>
    <message>
        <source>Prints JSON (docs/cli.md).</source>
        <translation>JSON を出力します（docs/cli.md）。</translation>
    </message>
    <message>
        <source>The backends and devices there are, and why one is missing.</source>
        <translation>使えるバックエンドとデバイス、および使えないものの理由。</translation>
    </message>
    <message>
        <source>give a file, or --backends</source>
        <translation>ファイルまたは --backends を指定してください</translation>
    </message>
    <message>
        <source>draw a painting into an image file</source>
        <translation>絵を画像ファイルに描画する</translation>
    </message>
    <message>
        <source>what a file holds; the backends there are</source>
        <translation>ファイルの内容、使えるバックエンド</translation>
    </message>
    <message>
        <source>between documents, the text form and recordings</source>
        <translation>ドキュメント、テキスト形式、記録の間で変換する</translation>
    </message>
    <message>
        <source>what lies at a point of the canvas</source>
        <translation>キャンバス上の一点にあるもの</translation>
    </message>
    <message>
        <source>compare the backends with the reference</source>
        <translation>バックエンドをリファレンスと比較する</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli COMMAND [options] …</source>
        <translation>使い方: suffuse-cli コマンド [オプション] …</translation>
    </message>
    <message>
        <source>%1: there is no such command. See suffuse-cli --help.</source>
        <translation>%1: そのようなコマンドはありません。suffuse-cli --help を参照してください。</translation>
    </message>
    <message>
        <source>Shows this help.</source>
        <translation>このヘルプを表示します。</translation>
    </message>
    <message>
        <source>too few arguments</source>
        <translation>引数が足りません</translation>
    </message>
    <message>
        <source>one argument too many: %1</source>
        <translation>引数が 1 つ多すぎます: %1</translation>
    </message>
    <message>
        <source>%1: %2. See suffuse-cli %1 --help.</source>
        <translation>%1: %2。suffuse-cli %1 --help を参照してください。</translation>
    </message>
    <message>
        <source>standard output cannot be written: %1</source>
        <translation>標準出力に書き込めません: %1</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>描画中</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>中止しました。何も書き込まれていません</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>%1 × %2 ピクセルを描画するにはメモリが足りません。より小さいサイズを選んでください。</translation>
    </message>
    <message>
        <source>--area %1: give X,Y,W,H in canvas units, W and H above 0</source>
        <translation>--area %1: X,Y,W,H をキャンバス単位で指定してください。W と H は 0 より大きい値です</translation>
    </message>
    <message>
        <source>--size %1: give WxH or W in pixels, e.g. 1024x768</source>
        <translation>--size %1: WxH または W をピクセルで指定してください。例: 1024x768</translation>
    </message>
    <message>
        <source>--scale %1: give pixels a unit, above 0, e.g. 2</source>
        <translation>--scale %1: 1 単位あたりのピクセル数を 0 より大きい値で指定してください。例: 2</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 million pixels. Choose a smaller --size, --scale or --area</source>
        <translation>%1 × %2 ピクセルの画像は大きすぎます。最大 %3 百万ピクセルです。--size、--scale、--area を小さくしてください</translation>
    </message>
    <message>
        <source>%1 pixels a unit are out of range: 0.001 to 1e9. Choose another --size, --scale or --area</source>
        <translation>1 単位あたり %1 ピクセルは範囲外です（0.001～1e9）。--size、--scale、--area を変えてください</translation>
    </message>
    <message>
        <source>give --size or --scale, not both</source>
        <translation>--size と --scale は、どちらか一方だけ指定してください</translation>
    </message>
    <message>
        <source>--size %1: the picture is scaled uniformly, so a width of %2 has the height %3: use --size %2x%3</source>
        <translation>--size %1: 画像は縦横比を保って拡大縮小されるため、幅 %2 のときの高さは %3 です。--size %2x%3 を使ってください</translation>
    </message>
    <message>
        <source>--time %1: give a moment in seconds, e.g. 1.5</source>
        <translation>--time %1: 時点を秒で指定してください。例: 1.5</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu, cuda or reference</source>
        <translation>--backend %1: auto、cpu、cuda、reference のいずれかを指定してください</translation>
    </message>
    <message>
        <source>--threads %1: give a number from 1 to 1024</source>
        <translation>--threads %1: 1～1024 の数を指定してください</translation>
    </message>
    <message>
        <source>stroke %1</source>
        <translation>ストローク %1</translation>
    </message>
    <message>
        <source>stroke %1, %2</source>
        <translation>ストローク %1、%2</translation>
    </message>
    <message>
        <source>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6 (red, yellow, blue, opacity)
  after it: RYB %7, RGB %8
</source>
        <translation>
  φ %1   ω̄ %2   φ′ %3   F %4   w %5
  C̄ %6（赤、黄、青、不透明度）
  この後: RYB %7, RGB %8
</translation>
    </message>
    <message>
        <source>  fill: φ %1, share %2
</source>
        <translation>  塗り: φ %1、割合 %2
</translation>
    </message>
    <message>
        <source>  segment %1: φ %2, share %3
</source>
        <translation>  セグメント %1: φ %2、割合 %3
</translation>
    </message>
    <message>
        <source>at %1, %2, %3 s: paper η %4, background RYB %5, RGB %6
</source>
        <translation>%1, %2、%3 s の時点: 紙 η %4、背景 RYB %5, RGB %6
</translation>
    </message>
    <message>
        <source>no stroke reaches this point
</source>
        <translation>この点に届くストロークはありません
</translation>
    </message>
    <message>
        <source>Tells what lies at a point of the canvas, stroke by stroke from bottom to top. X and Y are in canvas units.</source>
        <translation>キャンバス上の一点にあるものを、下から上へストロークごとに表示します。X と Y はキャンバス単位です。</translation>
    </message>
    <message>
        <source>The moment, in seconds (default: the end).</source>
        <translation>時点（秒、既定値は最後）。</translation>
    </message>
    <message>
        <source>%1 %2: give X and Y as numbers, in canvas units</source>
        <translation>%1 %2: X と Y をキャンバス単位の数で指定してください</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone; scales uniformly.</source>
        <translation>ピクセル: WxH または W のみ。縦横比は保たれます。</translation>
    </message>
    <message>
        <source>Pixels a canvas unit (default 1).</source>
        <translation>キャンバス 1 単位あたりのピクセル数（既定値 1）。</translation>
    </message>
    <message>
        <source>Part of the canvas, in canvas units (default: all of it).</source>
        <translation>キャンバスの一部（キャンバス単位、既定値は全体）。</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: the end).</source>
        <translation>描画する時点（秒、既定値は最後）。</translation>
    </message>
    <message>
        <source>No background: alpha holds the coverage.</source>
        <translation>背景なし。アルファが被覆率になります。</translation>
    </message>
    <message>
        <source>8, 16, half or float (default: the format&apos;s usual one).</source>
        <translation>8、16、half、float（既定値は形式の標準）。</translation>
    </message>
    <message>
        <source>auto, cpu, cuda or reference.</source>
        <translation>auto、cpu、cuda、reference のいずれか。</translation>
    </message>
    <message>
        <source>Number of threads (default: one a core).</source>
        <translation>スレッド数（既定ではコアごとに 1 つ）。</translation>
    </message>
    <message>
        <source>Prints times and counts as JSON.</source>
        <translation>時間と個数を JSON で出力します。</translation>
    </message>
    <message>
        <source>--depth %1: give 8, 16, half or float</source>
        <translation>--depth %1: 8、16、half、float のいずれかを指定してください</translation>
    </message>
    <message>
        <source>Draws a painting or a recording into an image file.</source>
        <translation>絵または記録を画像ファイルに描画します。</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the picture to write</source>
        <translation>-o OUT がありません。書き込む画像の名前を指定してください</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference R %3, G %4, B %5</source>
        <translation>%1 と %2: 最大の差 R %3, G %4, B %5</translation>
    </message>
    <message>
        <source>  at pixel %1, %2: RGB %3 and %4</source>
        <translation>  ピクセル %1, %2: RGB %3 と %4</translation>
    </message>
    <message>
        <source>  %1 of %2 pixels over 1/512</source>
        <translation>  %2 ピクセル中 %1 ピクセルが 1/512 を超過</translation>
    </message>
    <message>
        <source>  %1 pixels that are no numbers</source>
        <translation>  数値でないピクセル: %1</translation>
    </message>
    <message>
        <source>%1 and %2: largest difference in 8 bits %3, at pixel %4, %5</source>
        <translation>%1 と %2: 8 ビットでの最大の差 %3（ピクセル %4, %5）</translation>
    </message>
    <message>
        <source>%1, %2 × %3 pixels, at %4 s</source>
        <translation>%1、%2 × %3 ピクセル、%4 s の時点</translation>
    </message>
    <message>
        <source>within the contract</source>
        <translation>規定の範囲内</translation>
    </message>
    <message>
        <source>OVER the contract: 1/512 to the reference, 1 level of 8 bits between backends</source>
        <translation>規定を超過: リファレンスとの差は 1/512 まで、バックエンド間の差は 8 ビットで 1 段階まで</translation>
    </message>
    <message>
        <source>Draws a painting on every backend there is and on the reference, and compares the pictures.</source>
        <translation>使えるすべてのバックエンドとリファレンスで絵を描画し、画像を比較します。</translation>
    </message>
    <message>
        <source>Prints the rows as a JSON array.</source>
        <translation>行を JSON の配列で出力します。</translation>
    </message>
    <message>
        <source>Measures on this document instead of a generated painting of figure 11f&apos;s size.</source>
        <translation>図 11f の大きさの生成した絵の代わりに、このドキュメントで計測します。</translation>
    </message>
    <message>
        <source>all: every backend that can run here, one after the other.</source>
        <translation>all: ここで動くすべてのバックエンドを順に使います。</translation>
    </message>
    <message>
        <source>Numbers of threads; several: full renders with each (default: 1, and one a core).</source>
        <translation>スレッド数。複数なら、それぞれで全体を描画します（既定値は 1 とコア数）。</translation>
    </message>
    <message>
        <source>Pixels: WxH, or W alone (default: 1 px a unit, and full renders at 2.8125 px too).</source>
        <translation>ピクセル: WxH または W のみ（既定値は 1 単位 1 px、全体の描画は 2.8125 px でも）。</translation>
    </message>
    <message>
        <source>Names of rows, with commas between: takes these only.</source>
        <translation>行の名前をコンマで区切って指定します。その行だけを計測します。</translation>
    </message>
    <message>
        <source>Runs a row (default: 9).</source>
        <translation>1 行あたりの回数（既定値 9）。</translation>
    </message>
    <message>
        <source>Full renders of all thirteen sizes of the paper&apos;s Table 2 too.</source>
        <translation>論文の表 2 にある 13 種類すべてのサイズでも全体を描画します。</translation>
    </message>
    <message>
        <source>Range of the generated strokes&apos; spread, in units (default: 6 20).</source>
        <translation>生成するストロークの広がりの範囲（単位、既定値 6 20）。</translation>
    </message>
    <message>
        <source>Segments of the growth rows (default: 1000,10000,100000).</source>
        <translation>増加の行のセグメント数（既定値 1000,10000,100000）。</translation>
    </message>
    <message>
        <source>A growth row of 1000000 segments too.</source>
        <translation>セグメント数 1000000 の増加の行も計測します。</translation>
    </message>
    <message>
        <source>Width of the generated painting&apos;s canvas (default: 1024).</source>
        <translation>生成する絵のキャンバスの幅（既定値 1024）。</translation>
    </message>
    <message>
        <source>Height of the generated painting&apos;s canvas (default: 768).</source>
        <translation>生成する絵のキャンバスの高さ（既定値 768）。</translation>
    </message>
    <message>
        <source>Scale of the generated strokes (default: width / 1024).</source>
        <translation>生成するストロークの倍率（既定値は幅 / 1024）。</translation>
    </message>
    <message>
        <source>--%1 %2: give whole numbers from %3 to %4</source>
        <translation>--%1 %2: %3～%4 の整数を指定してください</translation>
    </message>
    <message>
        <source>--%1 %2: give a number above 0, at most %3</source>
        <translation>--%1 %2: 0 より大きく %3 以下の数を指定してください</translation>
    </message>
    <message>
        <source>--spread %1: give two numbers, e.g. --spread 6 20</source>
        <translation>--spread %1: 2 つの数を指定してください。例: --spread 6 20</translation>
    </message>
    <message>
        <source>--devices %1: give all, or leave it out</source>
        <translation>--devices %1: all を指定するか、省略してください</translation>
    </message>
    <message>
        <source>--only %1: the rows are %2</source>
        <translation>--only %1: 行は次のとおりです: %2</translation>
    </message>
    <message>
        <source>Measures how fast this machine draws: the figures of docs/performance.md.</source>
        <translation>このマシンの描画速度を計測します。docs/performance.md の数値になります。</translation>
    </message>
    <message>
        <source>measure how fast this machine draws</source>
        <translation>このマシンの描画速度を計測する</translation>
    </message>
    <message>
        <source>--devices %1: give all, or a number of GPUs, at least 1</source>
        <translation>--devices %1: all または 1 以上の GPU の数を指定してください</translation>
    </message>
    <message>
        <source>--devices is for CUDA: use it with --backend cuda</source>
        <translation>--devices は CUDA 用です。--backend cuda と一緒に使ってください</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the picture, all or a number (default 1).</source>
        <translation>CUDA の場合: 画像を分担する GPU。all または数（既定値 1）。</translation>
    </message>
    <message>
        <source>draw a painting while it is painted, as frames</source>
        <translation>描かれていく過程をフレームとして描画する</translation>
    </message>
    <message numerus="yes">
        <source>%n s left</source>
        <translation>
            <numerusform>残り %n 秒</numerusform>
        </translation>
    </message>
    <message>
        <source>Frames a second (default 25).</source>
        <translation>1 秒あたりのフレーム数（既定値 25）。</translation>
    </message>
    <message>
        <source>Length in seconds (default 10).</source>
        <translation>長さ（秒、既定値 10）。</translation>
    </message>
    <message>
        <source>Seconds that are kept of a pause in the painting (default 0.5).</source>
        <translation>描く合間の休止のうち残す秒数（既定値 0.5）。</translation>
    </message>
    <message>
        <source>With CUDA: GPUs that share the frames, all or a number (default 1).</source>
        <translation>CUDA の場合: フレームを分担する GPU。all または数（既定値 1）。</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to 1000000</source>
        <translation>--%1 %2: %3～1000000 の数を指定してください</translation>
    </message>
    <message>
        <source>%1 frames are too many: at most %2. Choose a smaller --fps or --duration</source>
        <translation>%1 フレームは多すぎます。最大 %2 です。--fps か --duration を小さくしてください</translation>
    </message>
    <message>
        <source>Draws a painting while it is painted, frame by frame.</source>
        <translation>絵が描かれていく過程を、1 フレームずつ描画します。</translation>
    </message>
    <message>
        <source>--brush %1: there is no such brush nor file; choose a file or one of %2</source>
        <translation>--brush %1: そのようなブラシもファイルもありません。ファイルか、次のいずれかを選んでください: %2</translation>
    </message>
    <message>
        <source>Frames with their number, film/%05d.png; or film.webp, .webm or .mp4.</source>
        <translation>番号付きのフレーム film/%05d.png、または film.webp、.webm、.mp4。</translation>
    </message>
    <message>
        <source>WebP: plays once instead of again and again.</source>
        <translation>WebP: 繰り返さず、1 回だけ再生します。</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the frames or the film to write</source>
        <translation>-o OUT がありません。書き込むフレームまたは動画の名前を指定してください</translation>
    </message>
    <message>
        <source>Leaves out what lies beside the picture: preview, view, undo history.</source>
        <translation>絵以外のもの（プレビュー、表示状態、取り消し履歴）を省きます。</translation>
    </message>
    <message>
        <source>Of a damaged document takes what is whole, and says what is missing.</source>
        <translation>破損したドキュメントから無事な部分を取り出し、欠けているものを表示します。</translation>
    </message>
    <message>
        <source>%1: is damaged; --salvage writes what is whole of it</source>
        <translation>%1: 破損しています。--salvage を使うと、無事な部分が書き込まれます</translation>
    </message>
    <message>
        <source>segments added: %1</source>
        <translation>追加されたセグメント: %1</translation>
    </message>
    <message>
        <source>segments removed: %1</source>
        <translation>削除されたセグメント: %1</translation>
    </message>
    <message>
        <source>%1 and %2 hold the same painting</source>
        <translation>%1 と %2 は同じ絵です</translation>
    </message>
    <message>
        <source>%1, segments: %2</source>
        <translation>%1、セグメント: %2</translation>
    </message>
    <message>
        <source>%1: from place %2 to %3</source>
        <translation>%1: 位置 %2 から %3 へ</translation>
    </message>
    <message>
        <source>Compares two paintings and tells what was added, removed and changed from A to B.</source>
        <translation>2 つの絵を比べ、A から B で追加、削除、変更されたものを表示します。</translation>
    </message>
    <message>
        <source>only one of the two can be standard input</source>
        <translation>2 つのうち標準入力にできるのは一方だけです</translation>
    </message>
    <message>
        <source>A picture that shows where: B pale, added strokes green, removed ones orange, changed and moved ones blue.</source>
        <translation>違いの場所を示す画像: B は薄く、追加されたストロークは緑、削除されたものはオレンジ、変更や移動されたものは青。</translation>
    </message>
    <message>
        <source>--%1 is for the picture; give -o OUT too</source>
        <translation>--%1 は画像用です。-o OUT も指定してください</translation>
    </message>
    <message>
        <source>preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>最後の表示状態</translation>
    </message>
    <message>
        <source>undo history</source>
        <translation>取り消し履歴</translation>
    </message>
    <message>
        <source>colour profile</source>
        <translation>カラープロファイル</translation>
    </message>
    <message>
        <source>size on paper</source>
        <translation>印刷サイズ</translation>
    </message>
    <message>
        <source>unknown to this version, kept</source>
        <translation>このバージョンでは不明（保持します）</translation>
    </message>
    <message>
        <source>  chunk     %1 at byte %2 is damaged: %3</source>
        <translation>  チャンク    %1（バイト %2）が破損しています: %3</translation>
    </message>
    <message>
        <source>  paper     %1</source>
        <translation>  紙          %1</translation>
    </message>
    <message>
        <source>what differs between two paintings, and where</source>
        <translation>2 つの絵で違うものと、その場所</translation>
    </message>
    <message>
        <source>what was not saved when the editor ended</source>
        <translation>エディターの終了時に保存されていなかったもの</translation>
    </message>
    <message>
        <source>in use by a running Suffuse</source>
        <translation>実行中の Suffuse が使用中</translation>
    </message>
    <message>
        <source>There is nothing to recover.
</source>
        <translation>復旧するものはありません。
</translation>
    </message>
    <message>
        <source>Lists what was painted and not saved when Suffuse ended unexpectedly, or writes one of it to a file.</source>
        <translation>Suffuse が予期せず終了したときに、描いて保存していなかったものを一覧表示するか、その 1 つをファイルに書き込みます。</translation>
    </message>
    <message>
        <source>Lists what there is; the same as no ID.</source>
        <translation>復旧できるものを一覧表示します。ID を省いたときと同じです。</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json.</source>
        <translation>書き込むファイル: .suffuse または .json。</translation>
    </message>
    <message>
        <source>give an ID and -o OUT, or neither</source>
        <translation>ID と -o OUT の両方を指定するか、どちらも省いてください</translation>
    </message>
    <message>
        <source>%1: there is no such journal to recover. See suffuse-cli recover --list.</source>
        <translation>%1: 復旧できるそのようなジャーナルはありません。suffuse-cli recover --list を参照してください。</translation>
    </message>
    <message>
        <source>The brush that recordings and drawings are painted with: a name, or a brush file.</source>
        <translation>記録とベクター画像を描くブラシ。名前またはブラシファイル。</translation>
    </message>
    <message>
        <source>%1: is IN itself, which would be lost; give OUT another name</source>
        <translation>%1: IN 自身であり、失われてしまいます。OUT に別の名前を指定してください</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read; -: standard input.</source>
        <translation>読み込む絵、記録、またはベクター画像。-: 標準入力。</translation>
    </message>
    <message>
        <source>The painting before; -: standard input.</source>
        <translation>変更前の絵。-: 標準入力。</translation>
    </message>
    <message>
        <source>The painting after; -: standard input.</source>
        <translation>変更後の絵。-: 標準入力。</translation>
    </message>
    <message>
        <source>How far right of the canvas&apos; left edge, in canvas units.</source>
        <translation>キャンバスの左端から右への距離（キャンバス単位）。</translation>
    </message>
    <message>
        <source>How far below the canvas&apos; upper edge, in canvas units.</source>
        <translation>キャンバスの上端から下への距離（キャンバス単位）。</translation>
    </message>
    <message>
        <source>Which one, as the list names it.</source>
        <translation>一覧に表示される、対象の ID。</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli %1 [options]</source>
        <translation>使い方: suffuse-cli %1 [オプション]</translation>
    </message>
    <message>
        <source>%1 is given twice; give it once</source>
        <translation>%1 が 2 回指定されています。1 回だけ指定してください</translation>
    </message>
    <message>
        <source>--time %1: nothing is painted before %2 s</source>
        <translation>--time %1: %2 s より前には何も描かれていません</translation>
    </message>
    <message>
        <source>--format is for an OUT of -; the ending of %1 chooses the format</source>
        <translation>--format は OUT が - のときに使います。形式は %1 の拡張子で決まります</translation>
    </message>
    <message>
        <source>--brush is ignored: the strokes of %1 have their looks already</source>
        <translation>--brush は無視されます。%1 のストロークにはすでに外観があります</translation>
    </message>
    <message numerus="yes">
        <source>%1: none of its %n stroke(s) is whole; open a backup of it</source>
        <translation>
            <numerusform>%1: %n 本のストロークのうち無事なものがありません。バックアップを開いてください</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 → %2: %3, %4 removed, %5 changed, %6 moved</source>
        <translation>%1 → %2: %3、削除 %4、変更 %5、移動 %6</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) added</source>
        <translation>
            <numerusform>ストローク %n 本を追加</numerusform>
        </translation>
    </message>
    <message>
        <source>suffuse-cli COMMAND --help lists the options of a command, and so does suffuse-cli help COMMAND. An input of - is standard input.
Exit codes: 0 done, 1 the work failed, 2 wrong usage.</source>
        <translation>suffuse-cli コマンド --help または suffuse-cli help コマンド で、そのコマンドのオプションを一覧表示します。入力に - を指定すると標準入力になります。
終了コード: 0 完了、1 処理に失敗、2 使い方の誤り。</translation>
    </message>
    <message>
        <source>The file to write: .suffuse or .json; -: standard output.</source>
        <translation>書き込むファイル: .suffuse または .json。-: 標準出力。</translation>
    </message>
    <message numerus="yes">
        <source>  %n segment(s) with a share below %1 left out (--all)
</source>
        <translation>
            <numerusform>  割合が %1 未満のセグメント %n 個を省略（--all）
</numerusform>
        </translation>
    </message>
    <message>
        <source>Lists segments with shares below a millionth, too.</source>
        <translation>割合が 100 万分の 1 未満のセグメントも表示します。</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>ストローク %n 本</numerusform>
        </translation>
    </message>
    <message>
        <source>-o %1: what is recovered is a painting: give a name that ends in .suffuse or .json. suffuse-cli render draws it then</source>
        <translation>-o %1: 復旧されるのは絵です。名前の末尾を .suffuse か .json にしてください。その後 suffuse-cli render で描画できます</translation>
    </message>
    <message>
        <source>The picture: .png, .tiff, .exr, .jpg, .webp or .pfm; .ora or .psd: its layers; -: standard output.</source>
        <translation>画像: .png、.tiff、.exr、.jpg、.webp、.pfm。.ora、.psd: そのレイヤー。-: 標準出力。</translation>
    </message>
    <message>
        <source>With -o -: png, tiff, exr, jpg, webp or pfm (default: png).</source>
        <translation>-o - の場合: png、tiff、exr、jpg、webp、pfm（既定値 png）。</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100 (default 92); WebP loses nothing at 100.</source>
        <translation>JPEG と WebP の画質（1～100、既定値 92）。WebP は 100 で無劣化です。</translation>
    </message>
    <message>
        <source>Pixels an inch, as the file says it (default: what makes the picture as large on paper as IN says that it is; else it says nothing).</source>
        <translation>ファイルに記される 1 インチあたりのピクセル数（既定では、印刷サイズが IN の示す大きさになる値。IN が示していなければ記されません）。</translation>
    </message>
    <message>
        <source>--format is for -o -; the ending of %1 chooses the format</source>
        <translation>--format は -o - のときに使います。形式は %1 の拡張子で決まります</translation>
    </message>
    <message>
        <source>--stats and -o - both write to standard output; give one</source>
        <translation>--stats と -o - はどちらも標準出力に書き込みます。一方だけ指定してください</translation>
    </message>
    <message>
        <source>standard output is a terminal, which shows no pictures; lead it into a file or a program</source>
        <translation>標準出力が端末であり、画像を表示できません。ファイルかプログラムに渡してください</translation>
    </message>
    <message>
        <source>--format %1: give one of %2</source>
        <translation>--format %1: %2 のいずれかを指定してください</translation>
    </message>
    <message>
        <source>--quality %1: give a whole number from 1 to 100</source>
        <translation>--quality %1: 1～100 の整数を指定してください</translation>
    </message>
    <message>
        <source>--quality is ignored: %1 loses nothing</source>
        <translation>--quality は無視されます。%1 は無劣化です</translation>
    </message>
    <message>
        <source>--dpi %1: give a number from 1 to 10000, e.g. 300</source>
        <translation>--dpi %1: 1～10000 の数を指定してください。例: 300</translation>
    </message>
    <message>
        <source>--dpi is ignored: %1 files hold no resolution</source>
        <translation>--dpi は無視されます。%1 ファイルは解像度を持ちません</translation>
    </message>
    <message>
        <source>  segment %1 fades: φ %2, which leaves %3
</source>
        <translation>  セグメント %1 が薄くする: φ %2、残り %3
</translation>
    </message>
    <message>
        <source>  segment %1 lifts: φ %2, share %3
</source>
        <translation>  セグメント %1 が吸い取る: φ %2、割合 %3
</translation>
    </message>
    <message>
        <source>untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, is missing or of another version, so texts are left out; install Suffuse again, with what suffuse-cli recommends</source>
        <translation>Suffuse の構成部品 %1 が見つからないか、別のバージョンのものです。そのためテキストは省かれます。suffuse-cli が推奨するものと一緒に、Suffuse をインストールし直してください</translation>
    </message>
    <message>
        <source>  groups    %1</source>
        <translation>  グループ    %1</translation>
    </message>
    <message>
        <source>%1 of them blending</source>
        <translation>うち単独で混色 %1</translation>
    </message>
    <message>
        <source>%1 clipped</source>
        <translation>クリッピング %1</translation>
    </message>
    <message>
        <source>%1 masking</source>
        <translation>マスク %1</translation>
    </message>
    <message>
        <source>%1 a wash</source>
        <translation>ウォッシュ %1</translation>
    </message>
    <message>
        <source>--transparent: the background is a layer of its own, which other programs can hide</source>
        <translation>--transparent: 背景は独立したレイヤーになり、ほかのプログラムで非表示にできます</translation>
    </message>
    <message>
        <source>--depth %1: layers have 8 or 16 bits</source>
        <translation>--depth %1: レイヤーは 8 ビットか 16 ビットです</translation>
    </message>
    <message>
        <source>--%1 is ignored: it is not for layered files</source>
        <translation>--%1 は無視されます。レイヤー付きファイルには使えません</translation>
    </message>
    <message>
        <source>drawing layers</source>
        <translation>レイヤーを描画中</translation>
    </message>
    <message>
        <source>there is not enough memory for layers of %1 × %2 pixels. Choose a smaller size.</source>
        <translation>%1 × %2 ピクセルのレイヤーを描画するにはメモリが足りません。より小さいサイズを選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>%n group(s) would look otherwise in other programs; their layers show what they make of the picture instead</source>
        <translation>
            <numerusform>%n 個のグループは、ほかのプログラムでは見え方が変わります。代わりに、それらのレイヤーには絵への効果の結果が入ります</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 shown alone</source>
        <translation>単独表示 %1</translation>
    </message>
    <message>
        <source>%1 a draft</source>
        <translation>下描き %1</translation>
    </message>
    <message>
        <source>  pictures  %1</source>
        <translation>  画像        %1</translation>
    </message>
    <message>
        <source>Draws groups that are drafts, too.</source>
        <translation>下描きのグループも描画します。</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse, .json, .svg, .svgz or .pdf</source>
        <translation>%1: 不明な拡張子です。.suffuse、.json、.svg、.svgz、.pdf を使ってください</translation>
    </message>
    <message>
        <source>Converts between documents (.suffuse) and the text form (.json), and from pen recordings and drawings, and to drawings (.svg, .svgz, .pdf). What IN is, is found from its content; what OUT is, from its ending.</source>
        <translation>ドキュメント（.suffuse）とテキスト形式（.json）の相互変換、ペンの記録やベクター画像からの変換、ベクター画像（.svg、.svgz、.pdf）への変換を行います。IN の種類は内容から、OUT の種類は拡張子から判断されます。</translation>
    </message>
    <message>
        <source>--format %1: give suffuse, json, svg or pdf</source>
        <translation>--format %1: suffuse、json、svg、pdf のいずれかを指定してください</translation>
    </message>
    <message>
        <source>Where OUT is -: suffuse, json, svg or pdf (default: json).</source>
        <translation>OUT が - の場合: suffuse、json、svg、pdf（既定値 json）。</translation>
    </message>
    <message>
        <source>--%1 is for drawings; give OUT the ending .svg or .pdf</source>
        <translation>--%1 はベクター画像用です。OUT の拡張子を .svg か .pdf にしてください</translation>
    </message>
    <message>
        <source>--as %1: give outlines, bands or hybrid</source>
        <translation>--as %1: outlines、bands、hybrid のいずれかを指定してください</translation>
    </message>
    <message>
        <source>--bands %1: give a whole number from 1 to %2</source>
        <translation>--bands %1: 1～%2 の整数を指定してください</translation>
    </message>
    <message>
        <source>--bands is for --as bands; leave one of them out</source>
        <translation>--bands は --as bands 用です。どちらかを省いてください</translation>
    </message>
    <message>
        <source>Where OUT is a drawing (.svg, .svgz, .pdf): outlines (a path a stroke), bands (contours within each other, as opaque as the paint; the default) or hybrid (the exact picture under unpainted outlines).</source>
        <translation>OUT がベクター画像（.svg、.svgz、.pdf）の場合: outlines（ストロークごとに 1 つのパス）、bands（絵の具の不透明度を持つ入れ子の等高線、既定値）、hybrid（描画されないアウトラインの下に正確な画像）。</translation>
    </message>
    <message>
        <source>How many bands full opacity has, 1 to 256 (default: 16).</source>
        <translation>不透明度 100 % までを分ける帯の数（1～256、既定値 16）。</translation>
    </message>
    <message>
        <source>The moment that is drawn, in seconds (default: all dried).</source>
        <translation>描画する時点（秒、既定ではすべて乾いた状態）。</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>描画中</translation>
    </message>
    <message>
        <source>ICC profile of RGB colours that the file has (default: sRGB).</source>
        <translation>ファイルが持つ RGB カラーの ICC プロファイル（既定値 sRGB）。</translation>
    </message>
    <message>
        <source>--profile %1: %2; give an ICC profile of RGB colours</source>
        <translation>--profile %1: %2。RGB カラーの ICC プロファイルを指定してください</translation>
    </message>
    <message>
        <source>Where OUT is a PDF: A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in, into which the sheet fits (default: the sheet as large as it is on paper; where that is not said, 96 units are an inch).</source>
        <translation>OUT が PDF の場合: A3、A4、A5、Letter、または 200x150mm や 8x6in のようなサイズ。用紙がこの中に収まります（既定では用紙の印刷サイズ。指定がなければ 96 単位が 1 インチ）。</translation>
    </message>
    <message>
        <source>--page is for PDF; give OUT the ending .pdf</source>
        <translation>--page は PDF 用です。OUT の拡張子を .pdf にしてください</translation>
    </message>
    <message>
        <source>--page %1: give A3, A4, A5, Letter, or a size such as 200x150mm or 8x6in</source>
        <translation>--page %1: A3、A4、A5、Letter、または 200x150mm や 8x6in のようなサイズを指定してください</translation>
    </message>
    <message>
        <source>several INs become the pages of a PDF; give OUT the ending .pdf</source>
        <translation>複数の IN は PDF のページになります。OUT の拡張子を .pdf にしてください</translation>
    </message>
    <message>
        <source>%1 is a picture: suffuse-cli render IN -o OUT writes pictures</source>
        <translation>%1 は画像です。画像の書き込みには suffuse-cli render IN -o OUT を使います</translation>
    </message>
    <message>
        <source>The painting to write: .suffuse or .json.</source>
        <translation>書き込む絵: .suffuse または .json。</translation>
    </message>
    <message>
        <source>At most so many strokes (default 512).</source>
        <translation>ストローク数の上限（既定値 512）。</translation>
    </message>
    <message>
        <source>At most so many numbers, 27 for each stroke.</source>
        <translation>数値の個数の上限。ストローク 1 本につき 27 個です。</translation>
    </message>
    <message>
        <source>As many strokes as this root mean square error needs, in 255ths.</source>
        <translation>この二乗平均平方根誤差（255 分の 1 単位）に必要な数のストローク。</translation>
    </message>
    <message>
        <source>So many paints, which become linked swatches.</source>
        <translation>絵の具の数。リンクされたスウォッチになります。</translation>
    </message>
    <message>
        <source>feathering (default), uniform or edge.</source>
        <translation>feathering（既定値）、uniform、edge。</translation>
    </message>
    <message>
        <source>No stroke is narrower, pixels of PICTURE.</source>
        <translation>ストロークの最小幅、PICTURE のピクセル単位。</translation>
    </message>
    <message>
        <source>No stroke is wider, pixels of PICTURE.</source>
        <translation>ストロークの最大幅、PICTURE のピクセル単位。</translation>
    </message>
    <message>
        <source>Another picture, white where PICTURE counts and black where not.</source>
        <translation>別の画像。PICTURE の考慮する部分が白、しない部分が黒。</translation>
    </message>
    <message>
        <source>The share of the error as people see it, 0 (default) to 1.</source>
        <translation>誤差のうち人の知覚に基づく割合（0～1、既定値 0）。</translation>
    </message>
    <message>
        <source>Goes on with a painting that was fitted before.</source>
        <translation>以前に近似した絵の続きから始めます。</translation>
    </message>
    <message>
        <source>How many steps (default 1200).</source>
        <translation>反復の回数（既定値 1200）。</translation>
    </message>
    <message>
        <source>PICTURE is averaged down to so many pixels (default 600000).</source>
        <translation>PICTURE をこのピクセル数まで平均して縮小します（既定値 600000）。</translation>
    </message>
    <message>
        <source>Other numbers give other strokes (default 1).</source>
        <translation>別の数にすると別のストロークになります（既定値 1）。</translation>
    </message>
    <message>
        <source>Prints how near the painting comes, as JSON (docs/cli.md).</source>
        <translation>絵がどれだけ近づいたかを JSON で出力します（docs/cli.md）。</translation>
    </message>
    <message>
        <source>--%1 %2: give a whole number from %3 to %4</source>
        <translation>--%1 %2: %3～%4 の整数を指定してください</translation>
    </message>
    <message>
        <source>--%1 %2: give a number from %3 to %4</source>
        <translation>--%1 %2: %3～%4 の数を指定してください</translation>
    </message>
    <message>
        <source>--style %1: give feathering, uniform or edge</source>
        <translation>--style %1: feathering、uniform、edge のいずれかを指定してください</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the painting to write</source>
        <translation>-o OUT がありません。書き込む絵の名前を指定してください</translation>
    </message>
    <message>
        <source>%1: unknown ending; use .suffuse or .json</source>
        <translation>%1: 不明な拡張子です。.suffuse か .json を使ってください</translation>
    </message>
    <message>
        <source>--strokes and --numbers say the same; give one of them</source>
        <translation>--strokes と --numbers は同じことを表します。一方だけ指定してください</translation>
    </message>
    <message>
        <source>--style goes without --from, whose strokes have a style already</source>
        <translation>--style は --from と併用できません。そのストロークにはすでにスタイルがあります</translation>
    </message>
    <message>
        <source>--greatest-width %1 is below --least-width %2</source>
        <translation>--greatest-width %1 が --least-width %2 より小さくなっています</translation>
    </message>
    <message>
        <source>%1: is a painting already; draw it with suffuse-cli render first</source>
        <translation>%1: すでに絵です。先に suffuse-cli render で描画してください</translation>
    </message>
    <message>
        <source>%1: there is no folder %2</source>
        <translation>%1: フォルダー %2 がありません</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1: 書き込めません</translation>
    </message>
    <message>
        <source>fitting</source>
        <translation>近似中</translation>
    </message>
    <message>
        <source>stopped; %1 has the strokes so far, and --from %1 goes on</source>
        <translation>中止しました。ここまでのストロークは %1 にあります。--from %1 で続けられます</translation>
    </message>
    <message>
        <source>Makes strokes that look like a picture, from the back to the front and large before small.</source>
        <translation>画像に似たストロークを、奥から手前へ、大きいものから小さいものへと作ります。</translation>
    </message>
    <message>
        <source>there is not enough memory to fit %1. Choose fewer --pixels.</source>
        <translation>%1 の近似にはメモリが足りません。--pixels を小さくしてください。</translation>
    </message>
    <message>
        <source>make a painting of a picture</source>
        <translation>画像から絵を作る</translation>
    </message>
    <message>
        <source>--strokes goes with --fit, which makes strokes of a picture</source>
        <translation>--strokes は --fit と一緒に使います。--fit は画像からストロークを作ります</translation>
    </message>
    <message>
        <source>--%1 says nothing of a picture that is fitted; leave it out</source>
        <translation>--%1 は、近似される画像には意味がありません。省いてください</translation>
    </message>
    <message>
        <source>--fit takes one IN at a time</source>
        <translation>--fit に指定できる IN は一度に 1 つです</translation>
    </message>
    <message>
        <source>Solves the diffusion curves of IN, or reads its picture, and makes strokes that look like it, as suffuse-cli fit does.</source>
        <translation>suffuse-cli fit と同じように、IN の拡散曲線を解くか画像を読み込み、それに似たストロークを作ります。</translation>
    </message>
    <message>
        <source>With --fit: at most so many strokes (default 512).</source>
        <translation>--fit の場合: ストローク数の上限（既定値 512）。</translation>
    </message>
    <message>
        <source>Also writes the picture that is fitted, as it was read, averaged or solved.</source>
        <translation>近似の対象となる画像も、読み込み、平均化、または求解した状態で書き込みます。</translation>
    </message>
    <message>
        <source>--target %1: unknown ending; use one of %2</source>
        <translation>--target %1: 不明な拡張子です。%2 のいずれかを使ってください</translation>
    </message>
    <message>
        <source>The picture to read: PNG, JPEG, TIFF, EXR, WebP or diffusion curves (XML); -: standard input.</source>
        <translation>読み込む画像: PNG、JPEG、TIFF、EXR、WebP、または拡散曲線（XML）。-: 標準入力。</translation>
    </message>
    <message>
        <source>make fewer strokes that look like those of a painting</source>
        <translation>絵のストロークを、見た目の似た少ないストロークにする</translation>
    </message>
    <message>
        <source>The strokes to make anew, by their ids, such as 3,7,20-180 (default: all).</source>
        <translation>作り直すストロークの ID。例: 3,7,20-180（既定値はすべて）。</translation>
    </message>
    <message>
        <source>All strokes of the group of that name, in place of --select.</source>
        <translation>--select の代わりに、この名前のグループのすべてのストローク。</translation>
    </message>
    <message>
        <source>A picture, or another painting, that the whole is to look like (default: as it does).</source>
        <translation>全体が目指す画像または別の絵（既定では今の見た目）。</translation>
    </message>
    <message>
        <source>At most so many strokes (default: a quarter of those before).</source>
        <translation>ストローク数の上限（既定値は元の 4 分の 1）。</translation>
    </message>
    <message>
        <source>What the strokes reach is fitted at so many pixels (default 600000).</source>
        <translation>ストロークの届く範囲を、このピクセル数で近似します（既定値 600000）。</translation>
    </message>
    <message>
        <source>Says how near the painting comes as JSON (docs/cli.md).</source>
        <translation>絵がどれだけ近づいたかを JSON で表示します（docs/cli.md）。</translation>
    </message>
    <message>
        <source>--select and --layer both say which strokes; give one of them</source>
        <translation>--select と --layer はどちらもストロークを指定します。一方だけ指定してください</translation>
    </message>
    <message>
        <source>--select %1: give ids of strokes, such as 3,7,20-180</source>
        <translation>--select %1: ストロークの ID を指定してください。例: 3,7,20-180</translation>
    </message>
    <message>
        <source>--select %1: there is no stroke %2; suffuse-cli convert IN OUT.json shows the ids</source>
        <translation>--select %1: ストローク %2 はありません。ID は suffuse-cli convert IN OUT.json で確認できます</translation>
    </message>
    <message>
        <source>--layer %1: several groups have that name; rename one of them</source>
        <translation>--layer %1: この名前のグループが複数あります。どれかの名前を変えてください</translation>
    </message>
    <message>
        <source>--layer %1: there is no group of that name</source>
        <translation>--layer %1: この名前のグループはありません</translation>
    </message>
    <message>
        <source>%1: is empty</source>
        <translation>%1: 空です</translation>
    </message>
    <message>
        <source>%1 strokes in place of %2. Where they are seen, the picture is %3 of 255 from what it should be (root mean square), %4 at most.</source>
        <translation>%2 本の代わりにストローク %1 本。見えている部分で、画像と目標との差は 255 段階中 %3（二乗平均平方根）、最大 %4 です。</translation>
    </message>
    <message>
        <source>Before it was %1, %2 at most.</source>
        <translation>以前は %1、最大 %2 でした。</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>間にあった %n 本のストロークは下に移りました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Makes fewer strokes that look like those of a painting, or makes them look like a picture, and says how near they come.</source>
        <translation>絵のストロークを見た目の似た少ないストロークにするか、画像に似せ、どれだけ近づいたかを表示します。</translation>
    </message>
    <message>
        <source>a small picture of a painting, for file managers</source>
        <translation>ファイルマネージャー用の、絵の縮小画像</translation>
    </message>
    <message>
        <source>The painting, recording or drawing to read.</source>
        <translation>読み込む絵、記録、またはベクター画像。</translation>
    </message>
    <message>
        <source>The PNG file to write; -: standard output.</source>
        <translation>書き込む PNG ファイル。-: 標準出力。</translation>
    </message>
    <message>
        <source>So many pixels a side at most, 1 to 1024.</source>
        <translation>一辺の最大ピクセル数（1～1024）。</translation>
    </message>
    <message>
        <source>Writes a small picture of a painting as a PNG file: the preview in the file, if it has one. File managers call this.</source>
        <translation>絵の縮小画像を PNG ファイルに書き込みます。ファイルにプレビューがあればそれを使います。ファイルマネージャーから呼び出されます。</translation>
    </message>
    <message>
        <source>%1: give SIDE as a whole number of pixels from 1 to %2</source>
        <translation>%1: SIDE には 1～%2 の整数をピクセルで指定してください</translation>
    </message>
    <message>
        <source>%1 of %2 pieces are there</source>
        <translation>ピース %2 個のうち %1 個がそろっています</translation>
    </message>
    <message>
        <source>%1: frames %2 are missing</source>
        <translation>%1: フレーム %2 がありません</translation>
    </message>
    <message>
        <source>%1: sheets %2 are missing</source>
        <translation>%1: シート %2 がありません</translation>
    </message>
    <message>
        <source>%1: two workers made different bits of piece %2. One of the machines is faulty: find it by the names in %3, remove its journal there, and run the tasks again.</source>
        <translation>%1: 2 つのワーカーが作ったピース %2 の内容が異なります。マシンのどれかに不具合があります。%3 の名前から特定し、そのジャーナルを削除して、タスクを実行し直してください。</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>読み込み中</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>joining</source>
        <translation>結合中</translation>
    </message>
    <message>
        <source>%1: sheet %2 cannot be read any more. Run the tasks again.</source>
        <translation>%1: シート %2 を読み込めなくなりました。タスクを実行し直してください。</translation>
    </message>
    <message>
        <source>Says what is missing, by what workers wrote down.</source>
        <translation>ワーカーの記録から、欠けているものを表示します。</translation>
    </message>
    <message>
        <source>Says what is missing or damaged, by reading all of it.</source>
        <translation>すべてを読み込み、欠けているものや破損したものを表示します。</translation>
    </message>
    <message>
        <source>Puts the pictures together, once all is there and whole.</source>
        <translation>すべてが無事にそろったら、画像を結合します。</translation>
    </message>
    <message>
        <source>Nothing was joined. Run the tasks again: they draw what is missing.</source>
        <translation>結合は行われませんでした。タスクを実行し直すと、欠けているものが描画されます。</translation>
    </message>
    <message>
        <source>say what is to be drawn, in a shared folder</source>
        <translation>描画するものを共有フォルダーに記す</translation>
    </message>
    <message>
        <source>draw a part of it, on any machine</source>
        <translation>その一部を任意のマシンで描画する</translation>
    </message>
    <message>
        <source>what is missing</source>
        <translation>欠けているもの</translation>
    </message>
    <message>
        <source>read all that is there, and compare the hashes</source>
        <translation>あるものをすべて読み込み、ハッシュを照合する</translation>
    </message>
    <message>
        <source>put the pictures together</source>
        <translation>画像を結合する</translation>
    </message>
    <message>
        <source>submit the work as a job array of Slurm</source>
        <translation>作業を Slurm のジョブ配列として投入する</translation>
    </message>
    <message>
        <source>print the work as an Open Job Description</source>
        <translation>作業を Open Job Description として出力する</translation>
    </message>
    <message>
        <source>print the work as a job type of Flamenco</source>
        <translation>作業を Flamenco のジョブタイプとして出力する</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli farm COMMAND [options] …</source>
        <translation>使い方: suffuse-cli farm コマンド [オプション] …</translation>
    </message>
    <message>
        <source>farm %1: there is no such command. See suffuse-cli farm --help.</source>
        <translation>farm %1: そのようなコマンドはありません。suffuse-cli farm --help を参照してください。</translation>
    </message>
    <message>
        <source>Into how many tasks the work is divided (default: one for 64 pieces).</source>
        <translation>作業を分けるタスクの数（既定値は 64 ピースごとに 1）。</translation>
    </message>
    <message>
        <source>--tasks %1: give a whole number, at least 1</source>
        <translation>--tasks %1: 1 以上の整数を指定してください</translation>
    </message>
    <message>
        <source>sbatch cannot be started: install Slurm (slurm-client), or use --write-only</source>
        <translation>sbatch を起動できません。Slurm（slurm-client）をインストールするか、--write-only を使ってください</translation>
    </message>
    <message>
        <source>Submits the tasks as a job array, and the joining after it.</source>
        <translation>タスクをジョブ配列として投入し、その後に結合を行います。</translation>
    </message>
    <message>
        <source>Cores of each task (default 2).</source>
        <translation>各タスクのコア数（既定値 2）。</translation>
    </message>
    <message>
        <source>Writes the scripts, and submits nothing.</source>
        <translation>スクリプトを書き込むだけで、投入しません。</translation>
    </message>
    <message>
        <source>--cpus %1: give a whole number, at least 1</source>
        <translation>--cpus %1: 1 以上の整数を指定してください</translation>
    </message>
    <message>
        <source>job %1: %2 tasks; job %3 joins what they draw</source>
        <translation>ジョブ %1: タスク %2 件。ジョブ %3 が描画結果を結合します</translation>
    </message>
    <message>
        <source>Prints a job template of the Open Job Description.</source>
        <translation>Open Job Description のジョブテンプレートを出力します。</translation>
    </message>
    <message>
        <source>Prints a job type of Flamenco 3 for its folder of scripts.</source>
        <translation>スクリプトフォルダー用の Flamenco 3 のジョブタイプを出力します。</translation>
    </message>
    <message>
        <source>%1: the plan is damaged, or of another version; make it anew</source>
        <translation>%1: 計画が破損しているか、別のバージョンのものです。作り直してください</translation>
    </message>
    <message>
        <source>the plan is damaged; make it anew</source>
        <translation>計画が破損しています。作り直してください</translation>
    </message>
    <message>
        <source>%1: there is another plan already. Remove the folder, or choose another one.</source>
        <translation>%1: すでに別の計画があります。フォルダーを削除するか、別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>%1: the folder cannot be made. Choose another one, or change its permissions.</source>
        <translation>%1: フォルダーを作成できません。別のフォルダーを選ぶか、アクセス権を変更してください。</translation>
    </message>
    <message>
        <source>%1: there is something else already. Remove it, or choose another name.</source>
        <translation>%1: すでに別のものがあります。削除するか、別の名前を選んでください。</translation>
    </message>
    <message>
        <source>%1: there is no plan (%2). Is the shared folder there? farm plan makes one.</source>
        <translation>%1: 計画がありません（%2）。共有フォルダーは接続されていますか？計画は farm plan で作成します。</translation>
    </message>
    <message>
        <source>%1: the folder is gone. Is the shared folder there?</source>
        <translation>%1: フォルダーがなくなっています。共有フォルダーは接続されていますか？</translation>
    </message>
    <message>
        <source>The folder of the farm, which all machines share.</source>
        <translation>すべてのマシンが共有する、ファームのフォルダー。</translation>
    </message>
    <message>
        <source>Frames of the paintings being painted: name%05d.png; of several, %s is the painting&apos;s name.</source>
        <translation>絵が描かれていく過程のフレーム: name%05d.png。絵が複数なら、%s が絵の名前になります。</translation>
    </message>
    <message>
        <source>Tiles of a Deep Zoom: jpg or png.</source>
        <translation>Deep Zoom のタイル: jpg または png。</translation>
    </message>
    <message>
        <source>8 or 16 bits (default 8).</source>
        <translation>8 または 16 ビット（既定値 8）。</translation>
    </message>
    <message>
        <source>Of JPEG and WebP, 1 to 100.</source>
        <translation>JPEG と WebP の画質（1～100）。</translation>
    </message>
    <message>
        <source>a farm draws numbered frames, name%05d.png</source>
        <translation>ファームは番号付きのフレーム name%05d.png を描画します</translation>
    </message>
    <message>
        <source>Plans the drawing of paintings by many machines.</source>
        <translation>多数のマシンによる絵の描画を計画します。</translation>
    </message>
    <message>
        <source>-o FOLDER is missing: name the folder that all machines share</source>
        <translation>-o FOLDER がありません。すべてのマシンが共有するフォルダーを指定してください</translation>
    </message>
    <message>
        <source>give --tiles or --frames</source>
        <translation>--tiles か --frames を指定してください</translation>
    </message>
    <message>
        <source>several paintings need several names: put %s where the painting&apos;s name is to stand, as in out/%s.dzi</source>
        <translation>複数の絵には別々の名前が必要です。絵の名前が入る位置に %s を置いてください。例: out/%s.dzi</translation>
    </message>
    <message>
        <source>%1: two paintings would become the same file. Rename one.</source>
        <translation>%1: 2 つの絵が同じファイルになります。どちらかの名前を変えてください。</translation>
    </message>
    <message>
        <source>--task %1: give i/n, e.g. 3/8, from 1/8 to 8/8</source>
        <translation>--task %1: i/n を指定してください。例: 3/8（1/8～8/8）</translation>
    </message>
    <message>
        <source>the plan is for %1 &quot;%2&quot;, and this machine has &quot;%3&quot;, which makes other bits. Use the same program on all machines, or make a new plan</source>
        <translation>計画は %1「%2」用ですが、このマシンのものは「%3」で、結果が一致しません。すべてのマシンで同じプログラムを使うか、新しい計画を作ってください</translation>
    </message>
    <message>
        <source>%1: the painting has changed since it was planned. Bring it back, or make a new plan.</source>
        <translation>%1: 計画の後に絵が変更されています。元の絵に戻すか、新しい計画を作ってください。</translation>
    </message>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start the task again.</source>
        <translation>%1 別のバックエンドの描画は結果が一致しないため、混在させません。タスクを開始し直してください。</translation>
    </message>
    <message>
        <source>Draws what is missing of a task; as often as is liked.</source>
        <translation>タスクのうち欠けているものを描画します。何度でも実行できます。</translation>
    </message>
    <message>
        <source>Which part: i/n, from 1/n to n/n (default 1/1).</source>
        <translation>担当する部分: i/n、1/n～n/n（既定値 1/1）。</translation>
    </message>
    <message>
        <source>stopped; what is finished is kept, and the same command goes on</source>
        <translation>中止しました。完了した分は保持され、同じコマンドで続けられます</translation>
    </message>
    <message>
        <source>task %1: %2 drawn, %3 there already</source>
        <translation>タスク %1: 描画 %2、既存 %3</translation>
    </message>
    <message>
        <source>let many machines draw pictures in tiles, and films</source>
        <translation>多数のマシンで、タイル画像や動画を描画する</translation>
    </message>
    <message>
        <source>a picture of %1 × %2 pixels is too large: at most %3 a side. Choose a smaller --size, --scale or --area</source>
        <translation>%1 × %2 ピクセルの画像は大きすぎます。一辺は最大 %3 です。--size、--scale、--area を小さくしてください</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1: フォルダーです。ファイル名を指定してください。</translation>
    </message>
    <message>
        <source>A picture of any size in tiles: OUT.dzi (Deep Zoom), OUT.tif (BigTIFF) or a folder; --format jpg or png.</source>
        <translation>任意の大きさのタイル画像: OUT.dzi（Deep Zoom）、OUT.tif（BigTIFF）、またはフォルダー。--format は jpg か png。</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side (default 254; TIFF 512).</source>
        <translation>--tiles の場合: 一辺のピクセル数（既定値 254、TIFF は 512）。</translation>
    </message>
    <message>
        <source>With --tiles: pixels that tiles show of their neighbours (default 1; TIFF 0).</source>
        <translation>--tiles の場合: 隣のタイルと重なるピクセル数（既定値 1、TIFF は 0）。</translation>
    </message>
    <message>
        <source>With --tiles: pixels a side of what is drawn at once (default 2048; CUDA 8192).</source>
        <translation>--tiles の場合: 一度に描画する部分の一辺のピクセル数（既定値 2048、CUDA は 8192）。</translation>
    </message>
    <message>
        <source>--%1 is not for --tiles</source>
        <translation>--%1 は --tiles には使えません</translation>
    </message>
    <message>
        <source>--tiles %1: the name is missing: give wall.dzi, wall.tif or a folder</source>
        <translation>--tiles %1: 名前がありません。wall.dzi、wall.tif、またはフォルダーを指定してください</translation>
    </message>
    <message>
        <source>--tiles %1: give a name that ends in .dzi or .tif, or a folder</source>
        <translation>--tiles %1: .dzi か .tif で終わる名前、またはフォルダーを指定してください</translation>
    </message>
    <message>
        <source>--format is for Deep Zoom: the tiles of a TIFF are packed in it</source>
        <translation>--format は Deep Zoom 用です。TIFF のタイルはファイル内に収められます</translation>
    </message>
    <message>
        <source>--format %1: tiles of a Deep Zoom are jpg or png</source>
        <translation>--format %1: Deep Zoom のタイルは jpg か png です</translation>
    </message>
    <message>
        <source>--depth %1: tiles have 8 or 16 bits</source>
        <translation>--depth %1: タイルは 8 ビットか 16 ビットです</translation>
    </message>
    <message>
        <source>tiles of JPEG hold 8 bits and no transparency: use --format png, or .tif</source>
        <translation>JPEG のタイルは 8 ビットで、透明にできません。--format png か .tif を使ってください</translation>
    </message>
    <message>
        <source>tiles of a TIFF do not overlap, and have sides of a multiple of 16</source>
        <translation>TIFF のタイルは重ならず、一辺は 16 の倍数です</translation>
    </message>
    <message numerus="yes">
        <source>%1: %2 pieces of %n painting(s)</source>
        <translation>
            <numerusform>%1: 絵 %n 点のピース %2 個</numerusform>
        </translation>
    </message>
    <message>
        <source>these are more than %1 pieces. Choose a greater --sheet, a smaller picture, or several plans.</source>
        <translation>ピースが %1 個を超えます。--sheet を大きくするか、画像を小さくするか、計画を分けてください。</translation>
    </message>
    <message>
        <source>other machines cannot read this standard input: give files</source>
        <translation>ほかのマシンはこの標準入力を読み込めません。ファイルを指定してください</translation>
    </message>
    <message>
        <source>auto (default: a GPU where there is one), cpu or cuda.</source>
        <translation>auto（既定値、あれば GPU）、cpu、cuda。</translation>
    </message>
    <message>
        <source>--backend %1: give auto, cpu or cuda</source>
        <translation>--backend %1: auto、cpu、cuda のいずれかを指定してください</translation>
    </message>
    <message>
        <source>the GPU failed (%1); the CPU went on</source>
        <translation>GPU に障害が起きました（%1）。CPU で続行しました</translation>
    </message>
    <message>
        <source>stopped before it came nearer than %1; nothing was written</source>
        <translation>%1 より近づく前に中止しました。何も書き込まれていません</translation>
    </message>
    <message>
        <source>--error %1 was not reached: it is %2. Give more --strokes or --iterations.</source>
        <translation>--error %1 に届きませんでした（%2）。--strokes か --iterations を増やしてください。</translation>
    </message>
    <message>
        <source>%1: is damaged</source>
        <translation>%1: 破損しています</translation>
    </message>
    <message>
        <source>%1: is missing</source>
        <translation>%1: ありません</translation>
    </message>
    <message numerus="yes">
        <source>%n more file(s) are missing or damaged; farm verify --json names all.</source>
        <translation>
            <numerusform>ほかに %n 個のファイルが欠けているか破損しています。farm verify --json ですべて表示されます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %n line(s) of this journal are damaged, so nobody knows what was finished. Run the tasks again: they draw what is missing.</source>
        <translation>
            <numerusform>%1: このジャーナルの %n 行が破損しており、何が完了したかわかりません。タスクを実行し直すと、欠けているものが描画されます。</numerusform>
        </translation>
    </message>
    <message>
        <source>the new strokes are farther from %1 than those before: %2 of 255, and before it was %3. Give more --strokes or --iterations.</source>
        <translation>新しいストロークは、元より %1 から離れています。255 段階中 %2（元は %3）。--strokes か --iterations を増やしてください。</translation>
    </message>
    <message>
        <source>%1 cannot be used</source>
        <translation>%1 は使えません</translation>
    </message>
    <message>
        <source>Lists the extensions that there are.</source>
        <translation>使える拡張機能を一覧表示します。</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: 読み込めません</translation>
    </message>
    <message>
        <source>%1: there is no such extension. See suffuse-cli extension list.</source>
        <translation>%1: そのような拡張機能はありません。suffuse-cli extension list を参照してください。</translation>
    </message>
    <message>
        <source>--set %1: give FIELD=VALUE with one of the fields %2</source>
        <translation>--set %1: 次のいずれかのフィールドで FIELD=VALUE を指定してください: %2</translation>
    </message>
    <message>
        <source>%1; give it by --set</source>
        <translation>%1。--set で指定してください</translation>
    </message>
    <message>
        <source>Runs an extension on a painting, and writes what it makes of it.</source>
        <translation>絵に対して拡張機能を実行し、結果を書き込みます。</translation>
    </message>
    <message>
        <source>A field&apos;s value; may be given several times.</source>
        <translation>フィールドの値。複数回指定できます。</translation>
    </message>
    <message>
        <source>The strokes that are selected, by their ids, such as 3,7,20-180.</source>
        <translation>選択するストロークの ID。例: 3,7,20-180。</translation>
    </message>
    <message>
        <source>The group that is painted on, by its name.</source>
        <translation>描画先のグループの名前。</translation>
    </message>
    <message>
        <source>-o OUT is missing: name the file to write</source>
        <translation>-o OUT がありません。書き込むファイルの名前を指定してください</translation>
    </message>
    <message>
        <source>%1 makes no painting; leave -o away</source>
        <translation>%1 は絵を作りません。-o を省いてください</translation>
    </message>
    <message>
        <source>%1: end the name with .suffuse or .json</source>
        <translation>%1: 名前の末尾を .suffuse か .json にしてください</translation>
    </message>
    <message>
        <source>Usage: suffuse-cli extension COMMAND [options] …</source>
        <translation>使い方: suffuse-cli extension コマンド [オプション] …</translation>
    </message>
    <message>
        <source>the extensions that there are, with their fields</source>
        <translation>使える拡張機能とそのフィールド</translation>
    </message>
    <message>
        <source>run one on a painting, and write what it makes of it</source>
        <translation>絵に対して実行し、結果を書き込む</translation>
    </message>
    <message>
        <source>extension %1: there is no such command. See suffuse-cli extension --help.</source>
        <translation>extension %1: そのようなコマンドはありません。suffuse-cli extension --help を参照してください。</translation>
    </message>
    <message>
        <source>run programs of others on a painting</source>
        <translation>外部のプログラムを絵に対して実行する</translation>
    </message>
    <message>
        <source>Its id, as extension list names it, or the path of its folder.</source>
        <translation>extension list に表示される ID、またはそのフォルダーのパス。</translation>
    </message>
    <message>
        <source>%1: it belongs to the farm in %2, and two farms would overwrite each other&apos;s pieces. Choose another name, or, if that farm is not wanted any more, remove its folder.</source>
        <translation>%1: %2 のファームのものです。2 つのファームが互いのピースを上書きしてしまいます。別の名前を選ぶか、そのファームが不要ならフォルダーを削除してください。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is another farm being planned?</source>
        <translation>%1: 書き込めません（%2）。別のファームを計画中ではありませんか？</translation>
    </message>
</context>
<context>
    <name>Clipboard</name>
    <message>
        <source>Paste</source>
        <translation>貼り付け</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Clipboard</source>
        <translation>クリップボード</translation>
    </message>
    <message>
        <source>There are no paths in the SVG of the clipboard.</source>
        <translation>クリップボードの SVG にはパスがありません。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) cannot lie there, too far out, and were left out.</source>
        <translation>
            <numerusform>ストローク %Ln 本は遠すぎてそこに置けないため、省かれました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, what was erased softly is left out: %n erasure(s).</source>
        <translation>
            <numerusform>ほかのプログラム用の SVG では、やわらかく消した跡 %n 個が省かれます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that mask, erase or clip what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG には、下のものをマスク、消去、クリッピングするグループがありません。%n 個のグループが通常のグループになりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>An erasure is not copied without the paint that it takes away. Duplicate doubles it within its stroke, Delete removes it.</source>
        <translation>消し跡は、消す対象の絵の具と一緒でなければコピーできません。「複製」でストローク内に複製、Delete キーで削除できます。</translation>
    </message>
    <message>
        <source>What was pasted lies outside of what is seen of the canvas. View ▸ Zoom to Selection goes there.</source>
        <translation>貼り付けたものは、キャンバスの見えている範囲の外にあります。「表示 ▸ 選択範囲にズーム」で表示できます。</translation>
    </message>
    <message>
        <source>There it would not be seen: what was pasted lies in the middle of what is seen of the canvas.</source>
        <translation>そこでは見えないため、貼り付けたものはキャンバスの見えている範囲の中央に置かれました。</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no washes: the strokes of %n group(s) lie over each other there.</source>
        <translation>
            <numerusform>SVG にはウォッシュがありません。%n 個のグループのストロークは重なって表示されます。</numerusform>
        </translation>
    </message>
    <message>
        <source>The clipboard holds no strokes, no SVG paths, no picture and no colour.</source>
        <translation>クリップボードに、ストローク、SVG パス、画像、色のどれもありません。</translation>
    </message>
    <message numerus="yes">
        <source>As SVG, for other programs, pictures are left out: %n of them.</source>
        <translation>
            <numerusform>ほかのプログラム用の SVG では、画像 %n 枚が省かれます。</numerusform>
        </translation>
    </message>
    <message>
        <source>What came was painted after the moment that you look at. It was brought back to this moment, so that you see it.</source>
        <translation>貼り付けたものは、表示中の時点より後に描かれていました。見えるように、この時点に移しました。</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Delete segments</source>
        <translation>セグメントを削除</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>セグメント %Ln 個を削除しました。「元に戻す」で戻せます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: %Ln stroke(s); Undo takes it back.</source>
        <translation>
            <numerusform>%1: ストローク %Ln 本。「元に戻す」で取り消せます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) deleted; Undo brings back.</source>
        <translation>
            <numerusform>ストローク %Ln 本を削除しました。「元に戻す」で戻せます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Delete strokes</source>
        <translation>ストロークを削除</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>複製</translation>
    </message>
    <message>
        <source>The erasure is there twice now, and takes twice: drag the copy, or move it with the arrow keys.</source>
        <translation>消し跡が二重になり、二度取り除いています。コピーをドラッグするか、矢印キーで移動してください。</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>前面へ</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>背面へ</translation>
    </message>
    <message>
        <source>Raise to top</source>
        <translation>最前面へ</translation>
    </message>
    <message>
        <source>Lower to bottom</source>
        <translation>最背面へ</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Flip horizontally</source>
        <translation>左右反転</translation>
    </message>
    <message>
        <source>Flip vertically</source>
        <translation>上下反転</translation>
    </message>
    <message>
        <source>Rotate by 90°</source>
        <translation>90° 回転</translation>
    </message>
    <message>
        <source>Align</source>
        <translation>整列</translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation>均等配置</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>グループ化</translation>
    </message>
    <message>
        <source>Ungroup</source>
        <translation>グループ解除</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>ストロークをロック</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>ストロークを隠す</translation>
    </message>
    <message>
        <source>Unlock all</source>
        <translation>すべてのロックを解除</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>すべて表示</translation>
    </message>
    <message>
        <source>Rename strokes</source>
        <translation>ストローク名を変更</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>グループ名を変更</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>簡略化</translation>
    </message>
    <message>
        <source>Smooth strokes</source>
        <translation>ストロークを滑らかにする</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>直線に近づける</translation>
    </message>
    <message>
        <source>Grow or shrink paint</source>
        <translation>絵の具を太く・細く</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>オフセット</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>選択したものはロックされているか、非表示です。</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>何も変わりません。</translation>
    </message>
    <message>
        <source>Apply brush</source>
        <translation>ブラシを適用</translation>
    </message>
    <message>
        <source>Apply form of the brush</source>
        <translation>ブラシの形状を適用</translation>
    </message>
    <message>
        <source>Apply colour of the brush</source>
        <translation>ブラシの色を適用</translation>
    </message>
    <message>
        <source>Apply texture of the brush</source>
        <translation>ブラシのテクスチャを適用</translation>
    </message>
    <message>
        <source>No appearance was copied.</source>
        <translation>外観がコピーされていません。</translation>
    </message>
    <message>
        <source>Paste appearance</source>
        <translation>外観を貼り付け</translation>
    </message>
    <message>
        <source>Combine strokes</source>
        <translation>ストロークを連結</translation>
    </message>
    <message>
        <source>Break apart</source>
        <translation>分解</translation>
    </message>
    <message>
        <source>Remove erasures</source>
        <translation>消し跡を削除</translation>
    </message>
    <message>
        <source>Recolour artwork</source>
        <translation>アートワークを再配色</translation>
    </message>
    <message>
        <source>The painting has no swatches yet.</source>
        <translation>この絵にはまだスウォッチがありません。</translation>
    </message>
    <message>
        <source>Map colours to swatches</source>
        <translation>色をスウォッチに置き換え</translation>
    </message>
    <message>
        <source>Not combined: one stroke has one fill, and these differ, overlap, or are missing in some strokes.</source>
        <translation>連結できません。1 本のストロークの塗りは 1 つですが、これらは異なるか、重なるか、一部のストロークにありません。</translation>
    </message>
    <message>
        <source>Aligning takes two strokes or groups that are not locked. A group counts as one; it can be aligned relative to the canvas.</source>
        <translation>整列には、ロックされていないストロークかグループが 2 つ必要です。グループは 1 つと数え、キャンバスを基準に整列できます。</translation>
    </message>
    <message>
        <source>Distributing takes three strokes or groups that are not locked. A group counts as one.</source>
        <translation>均等配置には、ロックされていないストロークかグループが 3 つ必要です。グループは 1 つと数えます。</translation>
    </message>
    <message>
        <source>Clip group to what lies below</source>
        <translation>グループを下でクリッピング</translation>
    </message>
    <message>
        <source>Clip group no more</source>
        <translation>グループのクリッピングを解除</translation>
    </message>
    <message>
        <source>Use group as mask</source>
        <translation>グループをマスクとして使用</translation>
    </message>
    <message>
        <source>Use group as mask no more</source>
        <translation>グループのマスクを解除</translation>
    </message>
    <message>
        <source>Make group a wash</source>
        <translation>グループをウォッシュにする</translation>
    </message>
    <message>
        <source>Make wash a plain group</source>
        <translation>ウォッシュを通常のグループにする</translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation>レイヤーを削除</translation>
    </message>
    <message>
        <source>Make group a draft</source>
        <translation>グループを下描きにする</translation>
    </message>
    <message>
        <source>Export draft again</source>
        <translation>グループの下描きを解除</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) now. Where their paint meets it mixes, and no longer adds up.</source>
        <translation>
            <numerusform>ストロークは %Ln 本になりました。絵の具が重なる部分は、加算されずに混ざります。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>ストローク %Ln 本を選択しました。もう一度 Delete で削除されます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s) selected. Delete once more deletes.</source>
        <translation>
            <numerusform>セグメント %Ln 個を選択しました。もう一度 Delete で削除されます。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>The selected strokes were exported last, and nothing is selected. Select strokes, or choose Export…</source>
        <translation>前回は選択したストロークをエクスポートしましたが、今は何も選択されていません。ストロークを選択するか、「エクスポート…」を選んでください。</translation>
    </message>
    <message>
        <source>There is nothing to export. Choose Export…</source>
        <translation>エクスポートするものがありません。「エクスポート…」を選んでください。</translation>
    </message>
</context>
<context>
    <name>FigureWarnings</name>
    <message>
        <source>Widest at %1 s; from then on it grows narrower while it spreads.</source>
        <translation>%1 s で最も広くなり、その後は広がりながら細くなります。</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the stroke has no clear edge and tints as far as its paint reaches. Up to %1 is clear.</source>
        <translation>ξ2 が ξ1 に対して大きすぎます。ストロークの縁がはっきりせず、絵の具の届く限り色が付きます。%1 まではっきりします。</translation>
    </message>
    <message>
        <source>ξ2 too large for ξ1: the paint inside the dark rim vanishes.</source>
        <translation>ξ2 が ξ1 に対して大きすぎます。濃い縁の内側の絵の具が消えます。</translation>
    </message>
    <message>
        <source>Density 0: there is no paint.</source>
        <translation>濃度 0：絵の具がありません。</translation>
    </message>
    <message>
        <source>Opacity 0 %: nothing of it is seen.</source>
        <translation>不透明度 0 %：まったく見えません。</translation>
    </message>
    <message>
        <source>Fades away at %1 s: nothing of it is seen after that. More φ, or less D or drying time, keeps it.</source>
        <extracomment>%1: seconds after it was painted</extracomment>
        <translation>%1 s で薄れて消え、その後は何も見えません。φ を増やすか、D か乾燥時間を減らすと残ります。</translation>
    </message>
    <message>
        <source>Parts fade away, the first at %1 s. More φ, or less D or drying time, keeps them.</source>
        <translation>一部が薄れて消えます（最初は %1 s）。φ を増やすか、D か乾燥時間を減らすと残ります。</translation>
    </message>
    <message>
        <source>Strength 0: nothing is taken away.</source>
        <translation>強さ 0：何も取り除かれません。</translation>
    </message>
</context>
<context>
    <name>FileReplacement</name>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1: 書き込めません（%2）。別のフォルダーを選ぶか、アクセス権を変更してください。</translation>
    </message>
    <message>
        <source>%1: the disk is full (%2). Free some space, or choose another disk.</source>
        <translation>%1: ディスクがいっぱいです（%2）。空きを作るか、別のディスクを選んでください。</translation>
    </message>
    <message>
        <source>%1: writing failed (%2). Choose another place.</source>
        <translation>%1: 書き込みに失敗しました（%2）。別の場所を選んでください。</translation>
    </message>
    <message>
        <source>%1: is a folder. Give a file name.</source>
        <translation>%1: フォルダーです。ファイル名を指定してください。</translation>
    </message>
    <message>
        <source>%1: is not a plain file. Choose another name.</source>
        <translation>%1: 通常のファイルではありません。別の名前を選んでください。</translation>
    </message>
    <message>
        <source>%1: the folder %2 does not exist. Create it, or choose another.</source>
        <translation>%1: フォルダー %2 はありません。作成するか、別のフォルダーを選んでください。</translation>
    </message>
</context>
<context>
    <name>Film</name>
    <message>
        <source>a film has %1 to %2 frames a second</source>
        <translation>動画は 1 秒あたり %1～%2 フレームです</translation>
    </message>
    <message>
        <source>MP4 cannot hold transparency. Use WebM, WebP or frames.</source>
        <translation>MP4 は透明にできません。WebM、WebP、またはフレームを使ってください。</translation>
    </message>
    <message>
        <source>a video has at most %1 pixels a side</source>
        <translation>ビデオの一辺は最大 %1 ピクセルです</translation>
    </message>
    <message>
        <source>%1: cannot write into this folder. Choose another one.</source>
        <translation>%1: このフォルダーには書き込めません。別のフォルダーを選んでください。</translation>
    </message>
    <message>
        <source>frames are numbered files: give a name such as film/%05d.png, or one that ends in .webp, .webm or .mp4</source>
        <translation>フレームは番号付きのファイルです。film/%05d.png のような名前か、.webp、.webm、.mp4 で終わる名前を指定してください</translation>
    </message>
    <message>
        <source>%1: ffmpeg, which makes videos, is not installed. Install it, or choose WebP or frames.</source>
        <translation>%1: ビデオを作る ffmpeg がインストールされていません。インストールするか、WebP またはフレームを選んでください。</translation>
    </message>
    <message>
        <source>%1: ffmpeg could not make the video (%2). Choose another format or size.</source>
        <translation>%1: ffmpeg がビデオを作成できませんでした（%2）。別の形式かサイズを選んでください。</translation>
    </message>
    <message>
        <source>%1: the film could not be written (%2).</source>
        <translation>%1: 動画を書き込めませんでした（%2）。</translation>
    </message>
    <message>
        <source>%1: the film is too large for WebP. Choose another format, a smaller size or fewer frames.</source>
        <translation>%1: 動画が WebP には大きすぎます。別の形式か、より小さいサイズ、少ないフレームを選んでください。</translation>
    </message>
</context>
<context>
    <name>ImageFormat</name>
    <message>
        <source>This is no image format that can be written. Use one of these endings: %1.</source>
        <translation>書き込める画像形式ではありません。次のいずれかの拡張子を使ってください: %1。</translation>
    </message>
    <message>
        <source>%1 cannot hold depth %2. Choose %3, or another format.</source>
        <translation>%1 では色深度 %2 を使えません。%3 か、別の形式を選んでください。</translation>
    </message>
    <message>
        <source>%1 cannot hold transparency. Use PNG, TIFF, EXR or WebP, or export with the background.</source>
        <translation>%1 は透明にできません。PNG、TIFF、EXR、WebP を使うか、背景付きでエクスポートしてください。</translation>
    </message>
    <message>
        <source>%1 holds 1 to %2 pixels a side, not %3 × %4. Choose another size or format.</source>
        <translation>%1 の一辺は 1～%2 ピクセルです。%3 × %4 にはできません。別のサイズか形式を選んでください。</translation>
    </message>
    <message>
        <source>A picture of %1 × %2 pixels is too large: at most %3 million pixels can be drawn. Choose a smaller size.</source>
        <translation>%1 × %2 ピクセルの画像は大きすぎます。描画できるのは最大 %3 百万ピクセルです。より小さいサイズを選んでください。</translation>
    </message>
    <message>
        <source>%1 cannot hold a colour profile. Use PNG, TIFF, JPEG or WebP, or export in sRGB.</source>
        <translation>%1 にはカラープロファイルを入れられません。PNG、TIFF、JPEG、WebP を使うか、sRGB でエクスポートしてください。</translation>
    </message>
</context>
<context>
    <name>ImageModule</name>
    <message>
        <source>is missing</source>
        <translation>見つかりません</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>読み込めません（%1）</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>Suffuse の別のバージョンのものです</translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again, with what suffuse-cli recommends. Pictures ending in .pfm work without it</source>
        <translation>Suffuse の構成部品 %1: %2。suffuse-cli が推奨するものと一緒に、Suffuse をインストールし直してください。.pfm の画像はこれがなくても使えます</translation>
    </message>
</context>
<context>
    <name>ImageReader</name>
    <message>
        <source>%1: the image declares more than %2 × %2 or %3 million pixels. Scale it down first.</source>
        <translation>%1: 画像の大きさが %2 × %2 または %3 百万ピクセルを超えています。先に縮小してください。</translation>
    </message>
    <message>
        <source>%1: is not a PNG, JPEG, TIFF, EXR or WebP image. Convert it to one of them.</source>
        <translation>%1: PNG、JPEG、TIFF、EXR、WebP の画像ではありません。いずれかに変換してください。</translation>
    </message>
    <message>
        <source>%1: cannot read %2: %3.</source>
        <translation>%1: %2 を読み込めません: %3。</translation>
    </message>
    <message>
        <source>%1: the %2 image cannot be read (%3). It may be damaged, or too large (at most %4 pixels a side, %5 million in all).</source>
        <translation>%1: %2 画像を読み込めません（%3）。破損しているか、大きすぎる可能性があります（一辺は最大 %4 ピクセル、全体で %5 百万ピクセル）。</translation>
    </message>
</context>
<context>
    <name>ImageWriter</name>
    <message>
        <source>%1: cannot write %2: %3.</source>
        <translation>%1: %2 を書き込めません: %3。</translation>
    </message>
    <message>
        <source>%1: writing was cancelled; nothing was changed.</source>
        <translation>%1: 書き込みをキャンセルしました。何も変更されていません。</translation>
    </message>
    <message>
        <source>%1: %2 could not be written (%3). Choose another format or depth.</source>
        <translation>%1: %2 を書き込めませんでした（%3）。別の形式か色深度を選んでください。</translation>
    </message>
    <message>
        <source>%1: the colour profile cannot be used: %2. Choose another one.</source>
        <translation>%1: カラープロファイルを使えません: %2。別のプロファイルを選んでください。</translation>
    </message>
</context>
<context>
    <name>Import</name>
    <message>
        <source>there are no strokes in it</source>
        <translation>ストロークが含まれていません</translation>
    </message>
    <message>
        <source>Import strokes</source>
        <translation>ストロークをインポート</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>Return</source>
        <extracomment>the key, as it is called on keyboards</extracomment>
        <translation>Enter</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>Save the changes to “%1” before closing?</source>
        <translation>閉じる前に「%1」への変更を保存しますか？</translation>
    </message>
    <message>
        <source>Suffuse did not come up the last times, so it has started with the usual settings. Yours are kept in %1.</source>
        <translation>Suffuse が続けて起動できなかったため、標準の設定で起動しました。元の設定は %1 に残っています。</translation>
    </message>
    <message>
        <source>Leave out the quotation marks: file dialogs take them for the borders between several names.</source>
        <translation>引用符は使わないでください。ファイルダイアログで複数の名前の区切りとして扱われます。</translation>
    </message>
    <message>
        <source>“%1” is only an ending. Give a name before it.</source>
        <translation>「%1」は拡張子だけです。その前に名前を付けてください。</translation>
    </message>
    <message>
        <source>Nothing is lost: the painting stays open as it is.</source>
        <translation>何も失われません。絵は今のまま開いています。</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Another program has changed “%1”.</source>
        <translation>別のプログラムが「%1」を変更しました。</translation>
    </message>
    <message>
        <source>The file stays as it is until you save.</source>
        <translation>保存するまで、ファイルはそのままです。</translation>
    </message>
    <message>
        <source>Overwriting gives up what the other program wrote.</source>
        <translation>上書きすると、別のプログラムが書き込んだ内容は失われます。</translation>
    </message>
    <message>
        <source>&amp;Overwrite</source>
        <translation>上書き(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Keep Mine</source>
        <translation>自分の変更を維持(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Reload</source>
        <translation>再読み込み(&amp;R)</translation>
    </message>
    <message>
        <source>Reloading takes away what was painted since the last save; Undo brings it back.</source>
        <translation>再読み込みすると、前回の保存以降に描いたものがなくなります。「元に戻す」で戻せます。</translation>
    </message>
    <message>
        <source>“%1” exists. Replace it?</source>
        <translation>「%1」はすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>置き換え(&amp;R)</translation>
    </message>
    <message>
        <source>Without saving, what has not been saved yet is lost.</source>
        <translation>保存しないと、未保存の変更は失われます。</translation>
    </message>
</context>
<context>
    <name>NodeDrag</name>
    <message>
        <source>Move nodes</source>
        <translation>ノードを移動</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>ノードを移動</translation>
    </message>
    <message>
        <source>Move handle</source>
        <translation>ハンドルを移動</translation>
    </message>
    <message>
        <source>Bend curve</source>
        <translation>曲線を曲げる</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>消し跡を移動</translation>
    </message>
</context>
<context>
    <name>Paper</name>
    <message>
        <source>paper image</source>
        <translation>紙の画像</translation>
    </message>
    <message>
        <source>paper image: there is none. Choose an image, or another kind of paper.</source>
        <translation>紙の画像がありません。画像か、別の種類の紙を選んでください。</translation>
    </message>
</context>
<context>
    <name>Papers</name>
    <message>
        <source>Smooth</source>
        <translation>細目</translation>
    </message>
    <message>
        <source>Cold press</source>
        <translation>中目</translation>
    </message>
    <message>
        <source>Rough</source>
        <translation>荒目</translation>
    </message>
    <message>
        <source>Rice</source>
        <translation>和紙</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>キャンバス地</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 を読み込めません: %2。</translation>
    </message>
    <message>
        <source>%1 is larger than 64 MB: choose a smaller picture.</source>
        <translation>%1 は 64 MB を超えています。より小さい画像を選んでください。</translation>
    </message>
</context>
<context>
    <name>ReferenceRenderer</name>
    <message>
        <source>%1 threads · double</source>
        <translation>%1 スレッド · 倍精度</translation>
    </message>
</context>
<context>
    <name>Renderer</name>
    <message numerus="yes">
        <source>%n threads</source>
        <translation>
            <numerusform>%n スレッド</numerusform>
        </translation>
    </message>
    <message>
        <source>The CUDA backend cannot run: %1. Use the CPU backend.</source>
        <translation>CUDA バックエンドを実行できません: %1。CPU バックエンドを使ってください。</translation>
    </message>
    <message>
        <source>%1 stopped: %2. The CPU draws now.</source>
        <translation>%1 が停止しました: %2。CPU で描画しています。</translation>
    </message>
    <message>
        <source>the picture is too large</source>
        <translation>画像が大きすぎます</translation>
    </message>
    <message>
        <source>this program was built without the CUDA renderer</source>
        <translation>このプログラムは CUDA レンダラーなしでビルドされています</translation>
    </message>
    <message>
        <source>no NVIDIA driver, or one that is too old for this program</source>
        <translation>NVIDIA ドライバーがないか、このプログラムには古すぎます</translation>
    </message>
    <message>
        <source>there is no NVIDIA GPU</source>
        <translation>NVIDIA の GPU がありません</translation>
    </message>
    <message>
        <source>the NVIDIA driver does not work</source>
        <translation>NVIDIA ドライバーが動作していません</translation>
    </message>
    <message>
        <source>there is not enough memory for %1 × %2 pixels. Choose a smaller size.</source>
        <translation>%1 × %2 ピクセルを描画するにはメモリが足りません。より小さいサイズを選んでください。</translation>
    </message>
    <message>
        <source>The reference finds no gradients. Use the CPU backend.</source>
        <translation>リファレンスは勾配を求めません。CPU バックエンドを使ってください。</translation>
    </message>
</context>
<context>
    <name>Retiming</name>
    <message>
        <source>Ease in time</source>
        <translation>時間のイージング</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>時間を移動</translation>
    </message>
    <message>
        <source>Stretch in time</source>
        <translation>時間を伸縮</translation>
    </message>
    <message>
        <source>%1, with its erasures</source>
        <translation>%1（消し跡も含む）</translation>
    </message>
    <message>
        <source>%1; erasures keep their time</source>
        <translation>%1（消し跡の時間はそのまま）</translation>
    </message>
    <message>
        <source>Later by %1 s</source>
        <translation>%1 s 後へ</translation>
    </message>
    <message>
        <source>Drawn in %1 s</source>
        <translation>%1 s で描画</translation>
    </message>
    <message>
        <source>Begins at %1 % of its pace</source>
        <translation>ペースの %1 % で開始</translation>
    </message>
    <message>
        <source>Ends at %1 % of its pace</source>
        <translation>ペースの %1 % で終了</translation>
    </message>
</context>
<context>
    <name>SelectHints</name>
    <message>
        <source>Drag: scale. Ctrl: keep the proportions. Shift: about the centre.</source>
        <translation>ドラッグ：拡大縮小。Ctrl：縦横比を固定。Shift：中心を基準。</translation>
    </message>
    <message>
        <source>Drag: rotate. Ctrl: in steps of 15°. Shift: about the opposite corner.</source>
        <translation>ドラッグ：回転。Ctrl：15° 刻み。Shift：反対側の角を基準。</translation>
    </message>
    <message>
        <source>Drag: skew. Ctrl: in steps of 15°. Shift: about the opposite side.</source>
        <translation>ドラッグ：傾斜。Ctrl：15° 刻み。Shift：反対側の辺を基準。</translation>
    </message>
    <message>
        <source>Drag: move the centre of rotation. Shift+click: back into the middle.</source>
        <translation>ドラッグ：回転の中心を移動。Shift+クリック：中央に戻す。</translation>
    </message>
    <message>
        <source>Shift+Alt+click: add the next stroke below, with Ctrl within its group. Shift+Alt+drag: add what the path touches.</source>
        <translation>Shift+Alt+クリック：次に下のストロークを追加（Ctrl でグループ内）。Shift+Alt+ドラッグ：なぞったものを追加。</translation>
    </message>
    <message>
        <source>Alt+click: select the next stroke below, with Ctrl within its group. Alt+drag: select what the path touches.</source>
        <translation>Alt+クリック：次に下のストロークを選択（Ctrl でグループ内）。Alt+ドラッグ：なぞったものを選択。</translation>
    </message>
    <message>
        <source>Ctrl+Shift+click: one stroke of a group, in or out. Ctrl+Shift+drag: take away.</source>
        <translation>Ctrl+Shift+クリック：グループ内の 1 本を追加・除外。Ctrl+Shift+ドラッグ：除外。</translation>
    </message>
    <message>
        <source>Ctrl+click: one stroke of a group. Ctrl+drag: move along an axis.</source>
        <translation>Ctrl+クリック：グループ内の 1 本。Ctrl+ドラッグ：軸に沿って移動。</translation>
    </message>
    <message>
        <source>Shift+click: add or take away. Shift+drag: add what the band encloses; while moving: do not snap.</source>
        <translation>Shift+クリック：追加・除外。Shift+ドラッグ：囲んだものを追加（移動中はスナップなし）。</translation>
    </message>
    <message>
        <source>Click paint to select its stroke. Drag for a band, over paint with Shift. Alt+click: the stroke below.</source>
        <translation>絵の具をクリックするとストロークを選択。ドラッグで囲んで選択（絵の具の上では Shift）。Alt+クリック：下のストローク。</translation>
    </message>
    <message>
        <source>Move by %1, %2</source>
        <translation>%1, %2 移動</translation>
    </message>
    <message>
        <source>Scale to %1 % × %2 %</source>
        <translation>%1 % × %2 % に拡大縮小</translation>
    </message>
    <message>
        <source>Rotate by %1</source>
        <translation>%1 回転</translation>
    </message>
    <message>
        <source>Skew by %1°</source>
        <translation>%1° 傾斜</translation>
    </message>
    <message>
        <source>Drag: move. Click again: turn and skew. Double click: values. Shift+click: add. Alt+click: the one below.</source>
        <translation>ドラッグ：移動。再クリック：回転と傾斜。ダブルクリック：値。Shift+クリック：追加。Alt+クリック：下のもの。</translation>
    </message>
</context>
<context>
    <name>SvgPaths</name>
    <message>
        <source>SVG, line %1: %2</source>
        <translation>SVG、%1 行目: %2</translation>
    </message>
</context>
<context>
    <name>TimelinePicture</name>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Each stroke is a bar here: from when it is painted until it is dry.</source>
        <translation>バーは 1 本のストロークを表します。描かれてから乾くまでの時間です。</translation>
    </message>
</context>
<context>
    <name>Underlay</name>
    <message>
        <source>%1: there is not enough memory for it.</source>
        <translation>%1: メモリが足りません。</translation>
    </message>
</context>
<context>
    <name>UnderlayCommands</name>
    <message>
        <source>Import underlay</source>
        <translation>下絵をインポート</translation>
    </message>
    <message>
        <source>Replace underlay</source>
        <translation>下絵を置き換え</translation>
    </message>
    <message>
        <source>Show underlay</source>
        <translation>下絵を表示</translation>
    </message>
    <message>
        <source>Hide underlay</source>
        <translation>下絵を隠す</translation>
    </message>
    <message>
        <source>Change underlay opacity</source>
        <translation>下絵の不透明度を変更</translation>
    </message>
    <message>
        <source>Move underlay</source>
        <translation>下絵を移動</translation>
    </message>
    <message>
        <source>Resize underlay</source>
        <translation>下絵のサイズを変更</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Fit underlay to the canvas</source>
        <translation>下絵をキャンバスに合わせる</translation>
    </message>
    <message>
        <source>Remove underlay</source>
        <translation>下絵を削除</translation>
    </message>
</context>
<context>
    <name>Validate</name>
    <message>
        <source>it is earlier than the one before it; put them in order of time</source>
        <translation>前のものより早い時間です。時間順に並べてください</translation>
    </message>
    <message>
        <source>another group has the same id</source>
        <translation>別のグループが同じ ID を持っています</translation>
    </message>
    <message>
        <source>there is no group with this id</source>
        <translation>この ID のグループはありません</translation>
    </message>
    <message>
        <source>the group would lie within itself</source>
        <translation>グループが自分自身の中に入ってしまいます</translation>
    </message>
    <message>
        <source>the group&apos;s members do not stand together in the order</source>
        <translation>グループのメンバーが続けて並んでいません</translation>
    </message>
    <message>
        <source>there is no such style</source>
        <translation>そのようなスタイルはありません</translation>
    </message>
    <message>
        <source>only edge darkening has a third value</source>
        <translation>3 番目の値があるのは濃い縁だけです</translation>
    </message>
    <message>
        <source>there is no such mixing mode</source>
        <translation>そのような混色モードはありません</translation>
    </message>
    <message>
        <source>only beta mixing has a beta</source>
        <translation>ベータがあるのはベータ混色だけです</translation>
    </message>
    <message>
        <source>there is no such kind of node</source>
        <translation>そのような種類のノードはありません</translation>
    </message>
    <message>
        <source>a stroke needs at least one</source>
        <translation>ストロークには少なくとも 1 つ必要です</translation>
    </message>
    <message>
        <source>a segment that lifts cannot fade as well</source>
        <translation>吸い取るセグメントは、同時に薄くすることはできません</translation>
    </message>
    <message>
        <source>the segment does not start where the one before it ends</source>
        <translation>セグメントが、前のセグメントの終点から始まっていません</translation>
    </message>
    <message>
        <source>there is no such kind of paper</source>
        <translation>そのような種類の紙はありません</translation>
    </message>
    <message>
        <source>the paper&apos;s image is missing</source>
        <translation>紙の画像がありません</translation>
    </message>
    <message>
        <source>the stroke is missing</source>
        <translation>ストロークがありません</translation>
    </message>
    <message>
        <source>another stroke has the same id</source>
        <translation>別のストロークが同じ ID を持っています</translation>
    </message>
    <message>
        <source>%1: %2 is not in %3</source>
        <translation>%1: %2 は %3 の範囲外です</translation>
    </message>
    <message>
        <source>there is no such kind</source>
        <translation>そのような種類はありません</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input</source>
        <translation>同じ量と入力の曲線がほかにあります</translation>
    </message>
    <message>
        <source>it needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>[0, 1] の範囲の点 [x, y] が、左から右へ 2～16 個必要です</translation>
    </message>
    <message>
        <source>there is no such rule</source>
        <translation>そのような規則はありません</translation>
    </message>
    <message>
        <source>it is the same point as from; a gradient needs two</source>
        <translation>from と同じ点です。グラデーションには 2 点が必要です</translation>
    </message>
    <message>
        <source>there is no such grain of paper</source>
        <translation>そのような紙目はありません</translation>
    </message>
    <message>
        <source>style.xi[1]: %1 is more than 2^(1/3) times xi[0], which is %2</source>
        <translation>style.xi[1]: %1 は xi[0]（%2）の 2^(1/3) 倍を超えています</translation>
    </message>
    <message>
        <source>there is no such alignment</source>
        <translation>そのような揃え方はありません</translation>
    </message>
    <message>
        <source>it is no valid Unicode</source>
        <translation>正しい Unicode ではありません</translation>
    </message>
    <message>
        <source>%1: %2 characters are more than %3</source>
        <translation>%1: %2 文字あり、上限 %3 を超えています</translation>
    </message>
    <message>
        <source>%1: %2 curves are more than %3</source>
        <translation>%1: 曲線が %2 本あり、上限 %3 を超えています</translation>
    </message>
    <message>
        <source>there is no such blend mode</source>
        <translation>そのような合成モードはありません</translation>
    </message>
    <message>
        <source>there is no such colour to mark groups</source>
        <translation>グループに付けるそのような色はありません</translation>
    </message>
    <message>
        <source>it needs an image, or a link with the SHA-256 of its file</source>
        <translation>画像、またはファイルの SHA-256 付きのリンクが必要です</translation>
    </message>
    <message>
        <source>it is no path of a file</source>
        <translation>ファイルのパスではありません</translation>
    </message>
    <message>
        <source>it has more than 67 million pixels</source>
        <translation>6700 万ピクセルを超えています</translation>
    </message>
    <message>
        <source>its corners lie on one line; a picture needs an area</source>
        <translation>四隅が一直線上にあります。画像には面積が必要です</translation>
    </message>
</context>
<context>
    <name>WidthHandle</name>
    <message>
        <source>Drag to set the width by the density, Shift: by the diffusion.</source>
        <translation>ドラッグすると濃度で幅を設定。Shift：拡散で設定。</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>幅を変更</translation>
    </message>
</context>
<context>
    <name>compare</name>
    <message>
        <source>The pictures differ in size (%1 × %2 and %3 × %4): render both at one size.</source>
        <translation>画像の大きさが異なります（%1 × %2 と %3 × %4）。同じ大きさで描画してください。</translation>
    </message>
</context>
<context>
    <name>suffuse::AboutDialog</name>
    <message>
        <source>About Suffuse</source>
        <translation>Suffuse について</translation>
    </message>
    <message>
        <source>Icon of Suffuse</source>
        <translation>Suffuse のアイコン</translation>
    </message>
    <message>
        <source>Suffuse %1</source>
        <translation>Suffuse %1</translation>
    </message>
    <message>
        <source>Paints with strokes that really diffuse, and stay editable.</source>
        <translation>本当ににじむストロークで描き、いつまでも編集できます。</translation>
    </message>
    <message>
        <source>Free software under the Apache License 2.0.</source>
        <translation>Apache License 2.0 のフリーソフトウェアです。</translation>
    </message>
</context>
<context>
    <name>suffuse::AgePlot</name>
    <message>
        <source>No paint here</source>
        <translation>ここに絵の具はありません</translation>
    </message>
    <message>
        <source>density φ, up to %1</source>
        <translation>濃度 φ（最大 %1）</translation>
    </message>
    <message>
        <source>0 s</source>
        <translation>0 s</translation>
    </message>
    <message>
        <source>age %1 s</source>
        <translation>経過 %1 s</translation>
    </message>
</context>
<context>
    <name>suffuse::AlongDialog</name>
    <message>
        <source>Along the Stroke</source>
        <translation>ストロークに沿って</translation>
    </message>
    <message>
        <source>Curve along the stroke</source>
        <translation>ストロークに沿った曲線</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>対象の値</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>一定</translation>
    </message>
    <message>
        <source>The same value all along</source>
        <translation>全体にわたって同じ値</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>直線変化</translation>
    </message>
    <message>
        <source>Evenly from one value to another</source>
        <translation>ある値から別の値へ均等に変化</translation>
    </message>
    <message>
        <source>Drawn</source>
        <translation>手描き</translation>
    </message>
    <message>
        <source>A curve drawn with the pointer</source>
        <translation>ポインターで描いた曲線</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>始点</translation>
    </message>
    <message>
        <source>End</source>
        <translation>終点</translation>
    </message>
    <message>
        <source>Change along the stroke</source>
        <translation>ストロークに沿って変更</translation>
    </message>
    <message>
        <source>Drag the line, its ends or its points; a press beside them makes a point, Del removes one. A drawn curve is drawn with the pointer. The dots are the values of the segments.</source>
        <translation>線、両端、点をドラッグします。点のない所を押すと点を追加、Delete で削除します。手描きの曲線はポインターで描きます。ドットはセグメントの値です。</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>The values that there are, as a curve of points that can be moved</source>
        <translation>今の値を、動かせる点の曲線で表します</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>加算</translation>
    </message>
    <message>
        <source>Multiplies all of it; what varies along the stroke stays</source>
        <translation>全体に掛けます。ストロークに沿った変化は残ります</translation>
    </message>
    <message>
        <source>Is added to all of it; what varies along the stroke stays</source>
        <translation>全体に加えます。ストロークに沿った変化は残ります</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>ストローク %1</translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s)</source>
        <translation>
            <numerusform>ストローク %n 本</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke – %1</source>
        <translation>ストロークに沿って – %1</translation>
    </message>
    <message>
        <source>Nothing is selected that can be changed. Click a stroke, and its values are shown here.</source>
        <translation>変更できるものが選択されていません。ストロークをクリックすると、その値がここに表示されます。</translation>
    </message>
</context>
<context>
    <name>suffuse::AreaRow</name>
    <message>
        <source>Area</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>Which part of the canvas is drawn</source>
        <translation>描画するキャンバスの部分</translation>
    </message>
    <message>
        <source>Whole canvas</source>
        <translation>キャンバス全体</translation>
    </message>
    <message>
        <source>What is painted</source>
        <translation>描かれている範囲</translation>
    </message>
    <message>
        <source>Selected strokes</source>
        <translation>選択したストローク</translation>
    </message>
    <message>
        <source>What the window shows</source>
        <translation>ウィンドウの表示範囲</translation>
    </message>
    <message>
        <source>By numbers</source>
        <translation>数値で指定</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge</source>
        <translation>左端</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge</source>
        <translation>上端</translation>
    </message>
    <message>
        <source>W</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>H</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantRow</name>
    <message>
        <source>Parallel Lines</source>
        <translation>平行線</translation>
    </message>
    <message>
        <source>Vanishing Point</source>
        <translation>消失点</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>パース</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>Concentric Ellipses</source>
        <translation>同心楕円</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>直線定規</translation>
    </message>
    <message>
        <source>What is made next</source>
        <translation>次に作るもの</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Horizontal place of the chosen point, canvas units</source>
        <translation>選んだ点の水平位置、キャンバス単位</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Vertical place of the chosen point, canvas units</source>
        <translation>選んだ点の垂直位置、キャンバス単位</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Angle of the line or of the first half axis, clockwise</source>
        <translation>線または第1半軸の角度、時計回り</translation>
    </message>
    <message>
        <source>a</source>
        <translation>a</translation>
    </message>
    <message>
        <source>First half axis of the ellipse, canvas units</source>
        <translation>楕円の第1半軸、キャンバス単位</translation>
    </message>
    <message>
        <source>b</source>
        <translation>b</translation>
    </message>
    <message>
        <source>Second half axis of the ellipse, canvas units</source>
        <translation>楕円の第2半軸、キャンバス単位</translation>
    </message>
    <message>
        <source>A new one in the middle of the view</source>
        <translation>ビューの中央に新しく作成</translation>
    </message>
    <message>
        <source>New assistant</source>
        <translation>新しい補助定規</translation>
    </message>
</context>
<context>
    <name>suffuse::AssistantTool</name>
    <message>
        <source>Drag for a new assistant; drag its points or lines to change it. Shift: in steps. Tab: next point. Return: a new one.</source>
        <translation>ドラッグで新しい補助定規。点や線をドラッグして変更。Shift：段階的に。Tab：次の点。Enter：新しく作成。</translation>
    </message>
    <message>
        <source>%1, point %2 of %3: x %4, y %5</source>
        <extracomment>%1: an assistant, as &quot;Vanishing Point&quot;</extracomment>
        <translation>%1、点 %2/%3：x %4、y %5</translation>
    </message>
</context>
<context>
    <name>suffuse::AttributeBrushTool</name>
    <message>
        <source>How fast it is laid down</source>
        <translation>塗り付ける速さ</translation>
    </message>
    <message>
        <source>Drag over strokes to paint the chosen value onto their segments. [ and ] change the size.</source>
        <translation>ストロークの上をドラッグすると、選んだ値がセグメントに付きます。[ と ] でサイズを変更。</translation>
    </message>
    <message>
        <source>Drag over the selection to paint the chosen value onto its segments. [ and ] change the size.</source>
        <translation>選択範囲の上をドラッグすると、選んだ値がセグメントに付きます。[ と ] でサイズを変更。</translation>
    </message>
    <message>
        <source>Paint diffusion</source>
        <translation>拡散を塗る</translation>
    </message>
    <message>
        <source>Paint density</source>
        <translation>濃度を塗る</translation>
    </message>
    <message>
        <source>Paint granulation</source>
        <translation>粒状化を塗る</translation>
    </message>
    <message>
        <source>Paint colour</source>
        <translation>色を塗る</translation>
    </message>
    <message>
        <source>Paint opacity</source>
        <translation>不透明度を塗る</translation>
    </message>
    <message>
        <source>Paint drying time</source>
        <translation>乾燥時間を塗る</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>A fill has a density of its own, ρ, which the inspector shows. It can be painted relative to what it is.</source>
        <translation>塗りには独自の濃度 ρ があり、インスペクターに表示されます。今の値を基準に塗ることができます。</translation>
    </message>
</context>
<context>
    <name>suffuse::BackupsDialog</name>
    <message>
        <source>Restore Backup</source>
        <translation>バックアップから復元</translation>
    </message>
    <message>
        <source>There is no backup of “%1” yet. When it is saved again, the version before is kept; Settings says how many are.</source>
        <translation>「%1」のバックアップはまだありません。次に保存すると、前のバージョンが残ります。残す数は「設定」で決めます。</translation>
    </message>
    <message>
        <source>An earlier version of “%1” takes the place of the painting as it is now. Undo brings that back, and no file changes until you save.</source>
        <translation>今の絵が「%1」の以前のバージョンに置き換わります。「元に戻す」で戻せます。保存するまでファイルは変わりません。</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>バックアップ（新しい順）</translation>
    </message>
    <message>
        <source>Saved</source>
        <translation>保存日時</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>復元(&amp;R)</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>読み込めません</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushColourPage</name>
    <message>
        <source>Second colour</source>
        <translation>2 番目の色</translation>
    </message>
    <message>
        <source>&amp;Take the Current Colour</source>
        <translation>現在の色を使う(&amp;T)</translation>
    </message>
    <message>
        <source>Makes the current colour the second one</source>
        <translation>現在の色を 2 番目の色にします</translation>
    </message>
    <message>
        <source>The row Second colour of the curves says when it comes through.</source>
        <translation>いつ現れるかは、曲線の「2 番目の色」の行で決まります。</translation>
    </message>
    <message>
        <source>Strays from the colour by</source>
        <translation>色のばらつき</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>At most so much redder or less red</source>
        <translation>赤みの増減の最大値</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>At most so much more or less yellow</source>
        <translation>黄みの増減の最大値</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>At most so much bluer or less blue</source>
        <translation>青みの増減の最大値</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>明るさ</translation>
    </message>
    <message>
        <source>At most so much lighter or darker</source>
        <translation>明るさの増減の最大値</translation>
    </message>
    <message>
        <source>Drifts along the stroke</source>
        <translation>ストロークに沿ってゆらぐ</translation>
    </message>
    <message>
        <source>Else each stroke has one colour</source>
        <translation>オフの場合、ストロークごとに 1 色です</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCombo</name>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>ブラシを検索</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushCurvesPage</name>
    <message>
        <source>Second colour</source>
        <translation>2 番目の色</translation>
    </message>
    <message>
        <source>Pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾き</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>By stroke</source>
        <translation>ストロークごと</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>ゆらぎ</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>What changes with what: a tick switches a curve on, a click shows it below</source>
        <translation>何が何によって変わるか。チェックで曲線をオンにし、クリックで下に表示します</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Drag points; click for another one, drag it out to take it away</source>
        <translation>点をドラッグ。クリックで点を追加、外へドラッグで削除</translation>
    </message>
    <message>
        <source>Full speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>Speed at the right end of its curves, in sizes a second</source>
        <translation>曲線の右端にあたる速度（1 秒あたりのサイズ数）</translation>
    </message>
    <message>
        <source> sizes/s</source>
        <translation> サイズ/s</translation>
    </message>
    <message>
        <source>Full distance</source>
        <translation>最大距離</translation>
    </message>
    <message>
        <source>Distance at the right end of its curves, in sizes</source>
        <translation>曲線の右端にあたる距離（サイズ数）</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> サイズ</translation>
    </message>
    <message>
        <source>Way on which what drifts becomes another, in sizes</source>
        <translation>ゆらぐ値が別の値になるまでの距離（サイズ数）</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushDialog</name>
    <message>
        <source>A stroke of the brush</source>
        <translation>ブラシのストローク</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>絵の具</translation>
    </message>
    <message>
        <source>Curves</source>
        <translation>曲線</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Shape and hand</source>
        <translation>形状と手の動き</translation>
    </message>
    <message>
        <source>Settings of the brush</source>
        <translation>ブラシの設定</translation>
    </message>
    <message>
        <source>Keeps the changes in the brush of this name; built-in brushes stay as they are</source>
        <translation>変更をこの名前のブラシに保存します。内蔵ブラシは変わりません</translation>
    </message>
    <message>
        <source>Keeps the brush under another name</source>
        <translation>ブラシを別の名前で保存します</translation>
    </message>
    <message>
        <source>Closes this window; the brush stays in hand as it is</source>
        <translation>このウィンドウを閉じます。ブラシは今の状態で使えます</translation>
    </message>
    <message>
        <source>Brush: %1</source>
        <translation>ブラシ：%1</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>変更を保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>新規ブラシとして保存(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushGrid</name>
    <message>
        <source>Brushes</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>%1: size %2, dry after %3</source>
        <translation>%1: サイズ %2、%3 で乾燥</translation>
    </message>
    <message>
        <source>Changed since the program was started; Reload in its menu undoes that</source>
        <translation>プログラムの起動後に変更されています。メニューの「再読み込み」で元に戻ります</translation>
    </message>
    <message>
        <source>There is no such brush.</source>
        <translation>そのようなブラシはありません。</translation>
    </message>
    <message>
        <source>Choose a brush to paint with it.</source>
        <translation>使うブラシを選んでください。</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushHandPage</name>
    <message>
        <source>Tip</source>
        <translation>筆先</translation>
    </message>
    <message>
        <source>Of the tip, against the path or the canvas</source>
        <translation>筆先の角度。描く方向またはキャンバスに対して</translation>
    </message>
    <message>
        <source>Turns with the path</source>
        <translation>描く方向に合わせて回転</translation>
    </message>
    <message>
        <source>Else it keeps its angle on the canvas, as a broad nib does</source>
        <translation>オフの場合、平ペンのようにキャンバスに対する角度を保ちます</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>両端</translation>
    </message>
    <message>
        <source> sizes</source>
        <translation> サイズ</translation>
    </message>
    <message>
        <source>Taper in</source>
        <translation>入り</translation>
    </message>
    <message>
        <source>Length on which the stroke grows from its tip</source>
        <translation>ストロークが先端から太くなるまでの長さ</translation>
    </message>
    <message>
        <source>Taper out</source>
        <translation>抜き</translation>
    </message>
    <message>
        <source>Length on which it runs out when the pen lifts</source>
        <translation>ペンを離すときに細くなっていく長さ</translation>
    </message>
    <message>
        <source>Tip size</source>
        <translation>先端サイズ</translation>
    </message>
    <message>
        <source>Size at the very end</source>
        <translation>一番端でのサイズ</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手の動き</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>手ブレ補正</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>手の動きを安定させます。ストロークがペンをゆるやかに追うか、ひもで引かれます</translation>
    </message>
    <message>
        <source>Sampling</source>
        <translation>サンプリング</translation>
    </message>
    <message>
        <source>Time between the points that the curve is fitted through</source>
        <translation>曲線を通す点と点の間の時間</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushLibrary</name>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: the folder could not be made; check its permissions</source>
        <translation>%1: フォルダーを作成できませんでした。アクセス権を確認してください</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; save it under a name of its own</source>
        <translation>%1 は内蔵ブラシです。独自の名前で保存してください</translation>
    </message>
    <message>
        <source>A brush needs a name</source>
        <translation>ブラシには名前が必要です</translation>
    </message>
    <message>
        <source>There is a brush “%1” already</source>
        <translation>ブラシ「%1」はすでにあります</translation>
    </message>
    <message>
        <source>%1 is a built-in brush; it stays</source>
        <translation>%1 は内蔵ブラシなので、削除できません</translation>
    </message>
    <message>
        <source>%1 could not be removed; check its permissions</source>
        <translation>%1 を削除できませんでした。アクセス権を確認してください</translation>
    </message>
    <message>
        <source>There is no brush “%1”</source>
        <translation>ブラシ「%1」はありません</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushMenu</name>
    <message>
        <source>&amp;Edit Brush…</source>
        <translation>ブラシを編集(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Favourite</source>
        <translation>お気に入り(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Save Changes</source>
        <translation>変更を保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save as &amp;New…</source>
        <translation>新規ブラシとして保存(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation>複製(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>名前を変更(&amp;R)…</translation>
    </message>
    <message>
        <source>De&amp;lete…</source>
        <translation>削除(&amp;L)…</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>インポート(&amp;I)…</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>エクスポート(&amp;X)…</translation>
    </message>
    <message>
        <source>Save Brush</source>
        <translation>ブラシを保存</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Rename Brush</source>
        <translation>ブラシ名を変更</translation>
    </message>
    <message>
        <source>Delete the brush “%1”?</source>
        <translation>ブラシ「%1」を削除しますか？</translation>
    </message>
    <message>
        <source>Strokes painted with it stay.</source>
        <translation>このブラシで描いたストロークは残ります。</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Import Brushes</source>
        <translation>ブラシをインポート</translation>
    </message>
    <message>
        <source>Brushes (*.suffuse-brush *.myb);;All files (*)</source>
        <translation>ブラシ (*.suffuse-brush *.myb);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>%1: these settings have no counterpart here: %2</source>
        <translation>%1: 次の設定に相当するものがありません: %2</translation>
    </message>
    <message>
        <source>Export Brush</source>
        <translation>ブラシをエクスポート</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Suffuse ブラシ</translation>
    </message>
    <message>
        <source>Rel&amp;oad</source>
        <translation>再読み込み(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Apply to Selection</source>
        <translation>選択範囲に適用(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>ブラシ全体(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>形状のみ(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>色のみ(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>テクスチャのみ(&amp;T)</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPaintPage</name>
    <message>
        <source>Style</source>
        <translation>スタイル</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>濃度から被覆率への変わり方。</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混色</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>絵の具が下のものとどう混ざるか。覆うか、顔料として加算されます。</translation>
    </message>
    <message>
        <source>How long the paint spreads; the size stays</source>
        <translation>絵の具が広がる時間。サイズは変わりません</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPalette</name>
    <message>
        <source>Zoom</source>
        <translation>ズーム</translation>
    </message>
    <message>
        <source>How large the painting is shown</source>
        <translation>絵の表示倍率</translation>
    </message>
    <message>
        <source>Brush palette</source>
        <translation>ブラシパレット</translation>
    </message>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>描画に使うブラシを選びます。色は変わりません。</translation>
    </message>
    <message>
        <source>Current colour</source>
        <translation>現在の色</translation>
    </message>
    <message>
        <source>Near colours</source>
        <translation>近い色</translation>
    </message>
    <message>
        <source>Lighter and darker, the neighbouring hues, and from grey to full</source>
        <translation>明暗、隣の色相、グレーから鮮やかな色まで</translation>
    </message>
    <message>
        <source>Painted with last</source>
        <translation>最近の描画に使った色</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>最近使った色</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushPanel</name>
    <message>
        <source>Choose what to paint with. The colour stays.</source>
        <translation>描画に使うブラシを選びます。色は変わりません。</translation>
    </message>
    <message>
        <source>Reset brush</source>
        <translation>ブラシをリセット</translation>
    </message>
    <message>
        <source>Back to the brush as it came</source>
        <translation>ブラシを元の状態に戻します</translation>
    </message>
    <message>
        <source>%1 (changed)</source>
        <translation>%1（変更あり）</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search brushes</source>
        <translation>ブラシを検索</translation>
    </message>
    <message>
        <source>Shows brushes and groups with this in their name</source>
        <translation>名前にこの文字を含むブラシとグループを表示します</translation>
    </message>
    <message>
        <source>Favourites only</source>
        <translation>お気に入りのみ</translation>
    </message>
    <message>
        <source>Show favourites only; the first nine have the keys 1 to 9</source>
        <translation>お気に入りだけを表示します。最初の 9 個にはキー 1～9 が割り当てられます</translation>
    </message>
    <message>
        <source>Brush menu</source>
        <translation>ブラシメニュー</translation>
    </message>
    <message>
        <source>Edit, save, import and export brushes</source>
        <translation>ブラシの編集、保存、インポート、エクスポート</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushTool</name>
    <message>
        <source>Brush stroke</source>
        <translation>ブラシストローク</translation>
    </message>
    <message>
        <source>Shift+drag to go on with the selected stroke from its end.</source>
        <translation>Shift+ドラッグ：選択したストロークを端から描き足します。</translation>
    </message>
    <message>
        <source>Extend stroke</source>
        <translation>ストロークを描き足す</translation>
    </message>
    <message>
        <source>This stroke lies beyond the canvas: View ▸ Show Paint beyond the Canvas shows it.</source>
        <translation>このストロークはキャンバスの外にあります。「表示 ▸ キャンバス外の絵の具を表示」で見えます。</translation>
    </message>
    <message>
        <source>All that you paint stays editable: press V and click paint to move, scale or recolour it.</source>
        <translation>描いたものはすべて後から編集できます。V を押して絵の具をクリックすると、移動、拡大縮小、色の変更ができます。</translation>
    </message>
    <message>
        <source>Drag to paint, tap for a dot. Right button: palette. Shift+drag: size, opacity. Ctrl+click: the picture&apos;s colour, with Shift the stroke&apos;s own.</source>
        <translation>ドラッグで描画、タップで点。右ボタン：パレット。Shift+ドラッグ：サイズ、不透明度。Ctrl+クリック：表示色を採取（Shift でストローク自体の色）。</translation>
    </message>
</context>
<context>
    <name>suffuse::BrushToolOptions</name>
    <message>
        <source>Width of a dry line at full pressure, in units ([ and ] change it)</source>
        <translation>最大の筆圧で描いて乾いた線の幅（単位、[ と ] で変更）</translation>
    </message>
    <message>
        <source>How much the paint covers ({ and } change it)</source>
        <translation>絵の具がどれだけ覆うか（{ と } で変更）</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>手ブレ補正</translation>
    </message>
    <message>
        <source>Steadies the hand: the stroke follows the pen softly, or is pulled on a string</source>
        <translation>手の動きを安定させます。ストロークがペンをゆるやかに追うか、ひもで引かれます</translation>
    </message>
    <message>
        <source>Amount of smoothing</source>
        <translation>手ブレ補正の量</translation>
    </message>
    <message>
        <source>How strongly it lags behind, or how long the string is</source>
        <translation>遅れの大きさ、またはひもの長さ</translation>
    </message>
    <message>
        <source>Own brush</source>
        <translation>独自のブラシ</translation>
    </message>
    <message>
        <source>What to paint with. Click: all brushes, with pictures.</source>
        <translation>描画に使うブラシ。クリック：すべてのブラシを見本付きで表示。</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasDrops</name>
    <message>
        <source>Drop colour</source>
        <translation>色をドロップ</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasMenu</name>
    <message>
        <source>Under the Pointer</source>
        <translation>ポインターの下</translation>
    </message>
    <message>
        <source>Further Below</source>
        <translation>さらに下</translation>
    </message>
    <message>
        <source>A&amp;rrange</source>
        <translation>重ね順(&amp;R)</translation>
    </message>
    <message>
        <source>R&amp;eshape</source>
        <translation>形の調整(&amp;E)</translation>
    </message>
    <message>
        <source>Dr&amp;ying</source>
        <translation>乾燥(&amp;Y)</translation>
    </message>
    <message>
        <source>Brush and C&amp;olours</source>
        <translation>ブラシと色(&amp;O)</translation>
    </message>
    <message>
        <source>Apply &amp;Brush</source>
        <translation>ブラシを適用(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>外観(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>ノード(&amp;N)</translation>
    </message>
    <message>
        <source>Trans&amp;form</source>
        <translation>変形(&amp;F)</translation>
    </message>
    <message>
        <source>Com&amp;bine and Break</source>
        <translation>連結と分解(&amp;B)</translation>
    </message>
    <message>
        <source>Select S&amp;ame</source>
        <translation>同じものを選択(&amp;A)</translation>
    </message>
    <message>
        <source>Under&amp;lay</source>
        <translation>下絵(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Colours</source>
        <translation>色(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasSection</name>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Background colour. Click: white.</source>
        <translation>背景色。クリック：白。</translation>
    </message>
    <message>
        <source>Change background</source>
        <translation>背景を変更</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>紙</translation>
    </message>
    <message>
        <source>Resize canvas</source>
        <translation>キャンバスサイズを変更</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>キャンバスの幅（単位数）。1 単位は 100 % 表示で 1 ピクセルです。</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height of the canvas in units; a unit is a pixel at 100 %.</source>
        <translation>キャンバスの高さ（単位数）。1 単位は 100 % 表示で 1 ピクセルです。</translation>
    </message>
    <message>
        <source>%1 × %2 mm at %3 dpi</source>
        <translation>%1 × %2 mm、%3 dpi</translation>
    </message>
    <message>
        <source>%1 × %2 in at %3 dpi</source>
        <translation>%1 × %2 in、%3 dpi</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>テクスチャ</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Image…</source>
        <translation>画像…</translation>
    </message>
    <message>
        <source>The paper&apos;s grain, which granulating strokes show.</source>
        <translation>紙目。粒状化するストロークに現れます。</translation>
    </message>
    <message>
        <source>Take the grain from another picture file.</source>
        <translation>別の画像ファイルから紙目を取り込みます。</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>Another number gives another grain.</source>
        <translation>別の数にすると別の紙目になります。</translation>
    </message>
    <message>
        <source>Change paper</source>
        <translation>紙を変更</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Paper image</source>
        <translation>紙の画像</translation>
    </message>
    <message>
        <source>%1 cannot be used as paper: %2</source>
        <translation>%1 は紙として使えません：%2</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>カスタム</translation>
    </message>
    <message>
        <source>Size of the coarsest grain or of a thread in units, or units per pixel of the image.</source>
        <translation>最も粗い目または糸の大きさ（単位）、または画像の 1 ピクセルあたりの単位数。</translation>
    </message>
    <message>
        <source>Choose &amp;Image…</source>
        <translation>画像を選択(&amp;I)…</translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasWidget</name>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>The picture goes to the screen by way of memory: %1</source>
        <translation>画像はメモリ経由で画面に表示されています：%1</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourChips</name>
    <message>
        <source>%1, opacity %2 %</source>
        <translation>%1、不透明度 %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourHeader</name>
    <message>
        <source>Shows and changes the colour that is painted with</source>
        <translation>描画色を表示し、変更します</translation>
    </message>
    <message>
        <source>Colour of what is selected</source>
        <translation>選択したものの色</translation>
    </message>
    <message>
        <source>Shows and changes the colour of what is selected; it keeps its opacity</source>
        <translation>選択したものの色を表示し、変更します。不透明度は変わりません</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>統一</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>ずらす</translation>
    </message>
    <message>
        <source>Several colours</source>
        <translation>複数の色</translation>
    </message>
    <message>
        <source>Set: all colours become the same.
Shift: all change as the shown one does, and keep their differences.</source>
        <translation>統一：すべて同じ色になります。
ずらす：表示中の色と同じだけ変わり、違いは保たれます。</translation>
    </message>
    <message>
        <source>Apply to selection</source>
        <translation>選択範囲に適用</translation>
    </message>
    <message>
        <source>Apply to selection: gives the selected segments the brush&apos;s colour. They keep their opacity.</source>
        <translation>選択範囲に適用：選択したセグメントにブラシの色を付けます。不透明度は変わりません。</translation>
    </message>
    <message>
        <source>Apply colour</source>
        <translation>色を適用</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>ブラシの色</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPanel</name>
    <message>
        <source>Current colour</source>
        <translation>現在の色</translation>
    </message>
    <message>
        <source>The colour that is painted with</source>
        <translation>描画色</translation>
    </message>
    <message>
        <source>Previous colour</source>
        <translation>前の色</translation>
    </message>
    <message>
        <source>The colour painted with last. Click: back to it.</source>
        <translation>前に使った描画色。クリック：その色に戻す。</translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>sRGB カラー：#rrggbb、#rgb、または CSS: rgb(255, 0, 128)、hsl(20, 50%, 40%)、teal</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>「%1」は色ではありません。#rrggbb の形で入力してください（例：#2f6690）。</translation>
    </message>
    <message>
        <source>Recent colours</source>
        <translation>最近使った色</translation>
    </message>
    <message>
        <source>Colours painted with before. Click: take it.</source>
        <translation>以前に描画に使った色。クリック：その色を使う。</translation>
    </message>
    <message>
        <source>Colours painted with come here.</source>
        <translation>描画に使った色がここに並びます。</translation>
    </message>
    <message>
        <source>RYB</source>
        <extracomment>red, yellow, blue; hue, saturation, value; red, green, blue</extracomment>
        <translation>RYB</translation>
    </message>
    <message>
        <source>HSV</source>
        <translation>HSV</translation>
    </message>
    <message>
        <source>RGB</source>
        <translation>RGB</translation>
    </message>
    <message>
        <source>Sliders</source>
        <translation>スライダー</translation>
    </message>
    <message>
        <source>The numbers that the sliders show: paint as red, yellow and blue, or the screen&apos;s hue, saturation and value, or its red, green and blue</source>
        <translation>スライダーの数値：絵の具の赤・黄・青、画面の色相・彩度・明度、または赤・緑・青</translation>
    </message>
    <message>
        <source>Colour of the brush</source>
        <translation>ブラシの色</translation>
    </message>
    <message>
        <source>The colour of the brush. Click: take it.</source>
        <translation>ブラシの色。クリック：その色を使う。</translation>
    </message>
    <message>
        <source>several</source>
        <translation>複数</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourTarget</name>
    <message>
        <source>Colour of the brush</source>
        <translation>ブラシの色</translation>
    </message>
    <message>
        <source>Colour of a swatch</source>
        <translation>スウォッチの色</translation>
    </message>
    <message>
        <source>Colour of the swatch “%1”</source>
        <translation>スウォッチ「%1」の色</translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln segment(s)</source>
        <translation>
            <numerusform>セグメント %Ln 個の色</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln segment(s)</source>
        <translation>
            <numerusform>セグメント %Ln 個の色</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colours of %Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本の色</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Colour of %Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本の色</numerusform>
        </translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>色を変更</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>不透明度を変更</translation>
    </message>
    <message>
        <source>Change swatch</source>
        <translation>スウォッチを変更</translation>
    </message>
    <message>
        <source>Colour of the fill</source>
        <translation>塗りの色</translation>
    </message>
    <message>
        <source>Colours of the fill</source>
        <translation>塗りの色</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s end</source>
        <translation>グラデーションの終点の色</translation>
    </message>
    <message>
        <source>Colour of the gradient&apos;s start</source>
        <translation>グラデーションの始点の色</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourWheel</name>
    <message>
        <source>Colour wheel</source>
        <translation>カラーサークル</translation>
    </message>
    <message>
        <source>Ring: hue in the order of pigments. Triangle: pure, white and black.
Arrow keys work too.</source>
        <translation>リング：顔料順の色相。三角形：純色、白、黒。
矢印キーも使えます。</translation>
    </message>
</context>
<context>
    <name>suffuse::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>コマンドを検索</translation>
    </message>
    <message>
        <source>Commands, brushes, docks, recent files</source>
        <translation>コマンド、ブラシ、ドック、最近使ったファイル</translation>
    </message>
    <message>
        <source>Parts of names in any order; Enter runs the chosen one, Escape goes back.</source>
        <translation>名前の一部を順不同で入力します。Enter で選択したものを実行、Esc で戻ります。</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>検索結果</translation>
    </message>
    <message>
        <source>Click one to run it.</source>
        <translation>クリックで実行します。</translation>
    </message>
    <message>
        <source>Nothing is called so.</source>
        <translation>該当するものがありません。</translation>
    </message>
    <message>
        <source>It cannot be used now.</source>
        <translation>今は使えません。</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>Open Recent</source>
        <translation>最近使ったファイルを開く</translation>
    </message>
    <message>
        <source>“%1” cannot be used now.</source>
        <translation>「%1」は今は使えません。</translation>
    </message>
</context>
<context>
    <name>suffuse::Commands</name>
    <message>
        <source>&amp;New…</source>
        <translation>新規(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>保存(&amp;S)</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>名前を付けて保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+S</source>
        <translation>Ctrl+Shift+S</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>エクスポート(&amp;E)…</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>&amp;Close Window</source>
        <translation>ウィンドウを閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Ctrl+Q</source>
        <translation>Ctrl+Q</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Dup&amp;licate</source>
        <translation>複製(&amp;L)</translation>
    </message>
    <message>
        <source>Ctrl+D</source>
        <translation>Ctrl+D</translation>
    </message>
    <message>
        <source>Select &amp;All</source>
        <translation>すべて選択(&amp;A)</translation>
    </message>
    <message>
        <source>D&amp;eselect</source>
        <translation>選択を解除(&amp;E)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>Settin&amp;gs…</source>
        <translation>設定(&amp;G)…</translation>
    </message>
    <message>
        <source>Ctrl+,</source>
        <translation>Ctrl+,</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>ブラシ(&amp;B)</translation>
    </message>
    <message>
        <source>Paint strokes</source>
        <translation>ストロークを描きます</translation>
    </message>
    <message>
        <source>&amp;Select</source>
        <translation>選択(&amp;S)</translation>
    </message>
    <message>
        <source>Select and move strokes</source>
        <translation>ストロークを選択して移動します</translation>
    </message>
    <message>
        <source>Se&amp;gments</source>
        <translation>セグメント(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Hand</source>
        <translation>手のひら(&amp;H)</translation>
    </message>
    <message>
        <source>Move the canvas</source>
        <translation>キャンバスを移動します</translation>
    </message>
    <message>
        <source>&amp;Raise</source>
        <translation>前面へ(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Lower</source>
        <translation>背面へ(&amp;L)</translation>
    </message>
    <message>
        <source>Raise to &amp;Top</source>
        <translation>最前面へ(&amp;T)</translation>
    </message>
    <message>
        <source>Lower to &amp;Bottom</source>
        <translation>最背面へ(&amp;B)</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>ズームイン(&amp;I)</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>ズームアウト(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;100 %</source>
        <translation>100 %(&amp;1)</translation>
    </message>
    <message>
        <source>&amp;Fit the Canvas</source>
        <translation>キャンバス全体を表示(&amp;F)</translation>
    </message>
    <message>
        <source>Turn &amp;Left</source>
        <translation>左に回転(&amp;L)</translation>
    </message>
    <message>
        <source>Turn &amp;Right</source>
        <translation>右に回転(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Upright</source>
        <translation>回転をリセット(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>左右反転表示(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Hide the Docks</source>
        <translation>ドックを隠す(&amp;H)</translation>
    </message>
    <message>
        <source>Reset La&amp;yout</source>
        <translation>レイアウトをリセット(&amp;Y)</translation>
    </message>
    <message>
        <source>Docks and tool bars go back to where they stand at the first start</source>
        <translation>ドックとツールバーを初回起動時の位置に戻します</translation>
    </message>
    <message>
        <source>Full S&amp;creen</source>
        <translation>全画面表示(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>キーボードショートカット(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;About Suffuse…</source>
        <translation>Suffuse について(&amp;A)…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>最近使ったファイルを開く(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Docks</source>
        <translation>ドック(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>ツール(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>ツール</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>切り取り(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>コピー(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>貼り付け(&amp;P)</translation>
    </message>
    <message>
        <source>Paste &amp;in Place</source>
        <translation>元の位置に貼り付け(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+V</source>
        <translation>Ctrl+Alt+V</translation>
    </message>
    <message>
        <source>Paste strokes where they were</source>
        <translation>ストロークを元の位置に貼り付けます</translation>
    </message>
    <message>
        <source>Edit segments, nodes and handles of strokes</source>
        <translation>ストロークのセグメント、ノード、ハンドルを編集します</translation>
    </message>
    <message>
        <source>&amp;Knife</source>
        <translation>ナイフ(&amp;K)</translation>
    </message>
    <message>
        <source>Cut strokes along a line</source>
        <translation>線に沿ってストロークを切断します</translation>
    </message>
    <message>
        <source>&amp;Eraser</source>
        <translation>消しゴム(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Attribute Brush</source>
        <translation>属性ブラシ(&amp;A)</translation>
    </message>
    <message>
        <source>Paint values onto segments</source>
        <translation>セグメントに値を塗り付けます</translation>
    </message>
    <message>
        <source>Eye&amp;dropper</source>
        <translation>スポイト(&amp;D)</translation>
    </message>
    <message>
        <source>Pick a colour</source>
        <translation>色を採取します</translation>
    </message>
    <message>
        <source>&amp;Insert Nodes</source>
        <translation>ノードを挿入(&amp;I)</translation>
    </message>
    <message>
        <source>Insert a node into each selected segment</source>
        <translation>選択した各セグメントにノードを挿入します</translation>
    </message>
    <message>
        <source>&amp;Corner</source>
        <translation>シャープ(&amp;C)</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>Make the selected nodes corners</source>
        <translation>選択したノードをシャープにします</translation>
    </message>
    <message>
        <source>&amp;Smooth</source>
        <translation>スムーズ(&amp;S)</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Make the selected nodes smooth</source>
        <translation>選択したノードをスムーズにします</translation>
    </message>
    <message>
        <source>S&amp;ymmetric</source>
        <translation>対称(&amp;Y)</translation>
    </message>
    <message>
        <source>Shift+Y</source>
        <translation>Shift+Y</translation>
    </message>
    <message>
        <source>Make the selected nodes symmetric</source>
        <translation>選択したノードを対称にします</translation>
    </message>
    <message>
        <source>&amp;Break Strokes</source>
        <translation>ストロークを切り離す(&amp;B)</translation>
    </message>
    <message>
        <source>Shift+B</source>
        <translation>Shift+B</translation>
    </message>
    <message>
        <source>Break strokes at the selected nodes</source>
        <translation>選択したノードでストロークを切り離します</translation>
    </message>
    <message>
        <source>&amp;Join Nodes</source>
        <translation>ノードを接続(&amp;J)</translation>
    </message>
    <message>
        <source>Shift+J</source>
        <translation>Shift+J</translation>
    </message>
    <message>
        <source>Join two selected end nodes</source>
        <translation>選択した 2 つの端点ノードを接続します</translation>
    </message>
    <message>
        <source>&amp;Delete Segments</source>
        <translation>セグメントを削除(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>Brid&amp;ge Segments</source>
        <translation>セグメントを橋渡し(&amp;G)</translation>
    </message>
    <message>
        <source>Alt+Del</source>
        <translation>Alt+Del</translation>
    </message>
    <message>
        <source>Replace selected segments by one that goes on smoothly</source>
        <translation>選択したセグメントを、滑らかにつながる 1 つのセグメントに置き換えます</translation>
    </message>
    <message>
        <source>&amp;Reverse</source>
        <translation>向きを反転(&amp;R)</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>Let the selected strokes run from end to start</source>
        <translation>選択したストロークの向きを、終点から始点へと逆にします</translation>
    </message>
    <message>
        <source>&amp;Object</source>
        <translation>オブジェクト(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Nodes</source>
        <translation>ノード(&amp;N)</translation>
    </message>
    <message>
        <source>In&amp;vert Selection</source>
        <translation>選択を反転(&amp;V)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+I</source>
        <translation>Ctrl+Shift+I</translation>
    </message>
    <message>
        <source>!</source>
        <translation>!</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>色(&amp;C)</translation>
    </message>
    <message>
        <source>Select all strokes of the same colour</source>
        <translation>同じ色のストロークをすべて選択します</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>スタイル(&amp;S)</translation>
    </message>
    <message>
        <source>Select all strokes of the same style</source>
        <translation>同じスタイルのストロークをすべて選択します</translation>
    </message>
    <message>
        <source>Select all strokes of the same brush</source>
        <translation>同じブラシのストロークをすべて選択します</translation>
    </message>
    <message>
        <source>&amp;Lasso</source>
        <translation>投げ縄(&amp;L)</translation>
    </message>
    <message>
        <source>L</source>
        <translation>L</translation>
    </message>
    <message>
        <source>Select what is drawn around; with Shift from paint, too</source>
        <translation>囲んだものを選択します。Shift で絵の具の上からも開始できます</translation>
    </message>
    <message>
        <source>&amp;Touch</source>
        <translation>なぞって選択(&amp;T)</translation>
    </message>
    <message>
        <source>Select what a path touches</source>
        <translation>ドラッグの軌跡が触れたものを選択します</translation>
    </message>
    <message>
        <source>&amp;Group</source>
        <translation>グループ化(&amp;G)</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>グループ解除(&amp;U)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Loc&amp;k</source>
        <translation>ロック(&amp;K)</translation>
    </message>
    <message>
        <source>Ctrl+2</source>
        <translation>Ctrl+2</translation>
    </message>
    <message>
        <source>U&amp;nlock All</source>
        <translation>すべてのロックを解除(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+2</source>
        <translation>Ctrl+Alt+2</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隠す(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+3</source>
        <translation>Ctrl+3</translation>
    </message>
    <message>
        <source>Sho&amp;w All</source>
        <translation>すべて表示(&amp;W)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+3</source>
        <translation>Ctrl+Alt+3</translation>
    </message>
    <message>
        <source>Rena&amp;me…</source>
        <translation>名前を変更(&amp;M)…</translation>
    </message>
    <message>
        <source>F2</source>
        <translation>F2</translation>
    </message>
    <message>
        <source>Flip Hori&amp;zontally</source>
        <translation>左右反転(&amp;Z)</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>Flip &amp;Vertically</source>
        <translation>上下反転(&amp;V)</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>Rotate by &amp;90° Left</source>
        <translation>左に 90° 回転(&amp;9)</translation>
    </message>
    <message>
        <source>Ctrl+[</source>
        <translation>Ctrl+[</translation>
    </message>
    <message>
        <source>Rotate by 90° R&amp;ight</source>
        <translation>右に 90° 回転(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+]</source>
        <translation>Ctrl+]</translation>
    </message>
    <message>
        <source>&amp;Scale Spread with the Shape</source>
        <translation>広がりも一緒に拡大縮小(&amp;S)</translation>
    </message>
    <message>
        <source>Spread and density follow the shape when it is scaled</source>
        <translation>拡大縮小するとき、広がりと濃度を形に合わせます</translation>
    </message>
    <message>
        <source>&amp;Left Edges</source>
        <translation>左端(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Centres, Horizontally</source>
        <translation>左右中央(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Right Edges</source>
        <translation>右端(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Top Edges</source>
        <translation>上端(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Middles, Vertically</source>
        <translation>上下中央(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Bottom Edges</source>
        <translation>下端(&amp;B)</translation>
    </message>
    <message>
        <source>Relative to the &amp;Selection</source>
        <translation>選択範囲を基準(&amp;S)</translation>
    </message>
    <message>
        <source>Relative to the C&amp;anvas</source>
        <translation>キャンバスを基準(&amp;A)</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Horizontally</source>
        <translation>等間隔（水平）(&amp;H)</translation>
    </message>
    <message>
        <source>Even Gaps, &amp;Vertically</source>
        <translation>等間隔（垂直）(&amp;V)</translation>
    </message>
    <message>
        <source>Even &amp;Centres, Horizontally</source>
        <translation>中心を等間隔（水平）(&amp;C)</translation>
    </message>
    <message>
        <source>Even C&amp;entres, Vertically</source>
        <translation>中心を等間隔（垂直）(&amp;E)</translation>
    </message>
    <message>
        <source>Snap to &amp;Nodes</source>
        <translation>ノードにスナップ(&amp;N)</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>Snap to &amp;Grid</source>
        <translation>グリッドにスナップ(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Show the Grid</source>
        <translation>グリッドを表示(&amp;S)</translation>
    </message>
    <message>
        <source>#</source>
        <translation>#</translation>
    </message>
    <message>
        <source>Grid St&amp;ep…</source>
        <translation>グリッド間隔(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Align</source>
        <translation>整列(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Distribute</source>
        <translation>均等配置(&amp;D)</translation>
    </message>
    <message>
        <source>Select Sa&amp;me</source>
        <translation>同じものを選択(&amp;M)</translation>
    </message>
    <message>
        <source>Ctrl+1</source>
        <translation>Ctrl+1</translation>
    </message>
    <message>
        <source>Ctrl+4</source>
        <translation>Ctrl+4</translation>
    </message>
    <message>
        <source>Ctrl+6</source>
        <translation>Ctrl+6</translation>
    </message>
    <message>
        <source>Ctrl+5</source>
        <translation>Ctrl+5</translation>
    </message>
    <message>
        <source>Ti&amp;me</source>
        <translation>時間(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Favourite Brushes</source>
        <translation>お気に入りのブラシ(&amp;F)</translation>
    </message>
    <message>
        <source>Favourite Brush %1</source>
        <translation>お気に入りのブラシ %1</translation>
    </message>
    <message>
        <source>Relative to the &amp;First Selected</source>
        <translation>最初に選択したものを基準(&amp;F)</translation>
    </message>
    <message>
        <source>Relative to the Bi&amp;ggest</source>
        <translation>最大のものを基準(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>Play the painting being painted, or pause</source>
        <translation>絵が描かれていく過程を再生、または一時停止します</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>始めへ(&amp;S)</translation>
    </message>
    <message>
        <source>Shift+,</source>
        <translation>Shift+,</translation>
    </message>
    <message>
        <source>Go to where the painting begins</source>
        <translation>絵の描き始めへ移動します</translation>
    </message>
    <message>
        <source>P&amp;revious Stroke</source>
        <translation>前のストローク(&amp;R)</translation>
    </message>
    <message>
        <source>,</source>
        <translation>,</translation>
    </message>
    <message>
        <source>Go back to where a stroke begins</source>
        <translation>ストロークの始まりへ戻ります</translation>
    </message>
    <message>
        <source>&amp;Next Stroke</source>
        <translation>次のストローク(&amp;N)</translation>
    </message>
    <message>
        <source>.</source>
        <translation>.</translation>
    </message>
    <message>
        <source>Go on to where a stroke begins</source>
        <translation>ストロークの始まりへ進みます</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>終わりへ(&amp;E)</translation>
    </message>
    <message>
        <source>Shift+.</source>
        <translation>Shift+.</translation>
    </message>
    <message>
        <source>Go to the end, where all has dried: the present</source>
        <translation>終わりへ移動します。すべてが乾いた現在です</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>ループ(&amp;L)</translation>
    </message>
    <message>
        <source>Play again and again</source>
        <translation>繰り返し再生します</translation>
    </message>
    <message>
        <source>S&amp;kip Pauses</source>
        <translation>休止をスキップ(&amp;K)</translation>
    </message>
    <message>
        <source>Cut pauses in which nothing is painted or spreads to half a second</source>
        <translation>何も描かれず広がりもしない休止を、0.5 秒に縮めます</translation>
    </message>
    <message>
        <source>Preview When &amp;Dry</source>
        <translation>乾いた状態でプレビュー(&amp;D)</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Show wet paint as it will look when it has dried, while you paint too</source>
        <translation>濡れた絵の具を、描いている間も乾いた後の見た目で表示します</translation>
    </message>
    <message>
        <source>Let It Dr&amp;y</source>
        <translation>乾かす(&amp;Y)</translation>
    </message>
    <message>
        <source>Go to the moment at which all has dried</source>
        <translation>すべてが乾いた時点へ移動します</translation>
    </message>
    <message>
        <source>&amp;Freeze Wet Paint</source>
        <translation>濡れた絵の具を固定(&amp;F)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+F</source>
        <translation>Ctrl+Alt+F</translation>
    </message>
    <message>
        <source>All that is wet stops spreading at this moment</source>
        <translation>濡れているものの広がりを、この時点で止めます</translation>
    </message>
    <message>
        <source>Re-&amp;wet…</source>
        <translation>濡らし直す(&amp;W)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+W</source>
        <translation>Ctrl+Alt+W</translation>
    </message>
    <message>
        <source>Let the selected paint spread on for a while from this moment</source>
        <translation>選択した絵の具を、この時点からしばらく広げます</translation>
    </message>
    <message>
        <source>Remove Re-we&amp;tting</source>
        <translation>濡らし直しを削除(&amp;T)</translation>
    </message>
    <message>
        <source>The selected paint dries once and for all</source>
        <translation>選択した絵の具は一度だけ乾くようになります</translation>
    </message>
    <message>
        <source>&amp;Even</source>
        <translation>均一(&amp;E)</translation>
    </message>
    <message>
        <source>Selected strokes are drawn at an even pace</source>
        <translation>選択したストロークを均一なペースで描きます</translation>
    </message>
    <message>
        <source>Ease &amp;In</source>
        <translation>イーズイン(&amp;I)</translation>
    </message>
    <message>
        <source>Selected strokes begin slowly</source>
        <translation>選択したストロークをゆっくり始めます</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>イーズアウト(&amp;O)</translation>
    </message>
    <message>
        <source>Selected strokes end slowly</source>
        <translation>選択したストロークをゆっくり終えます</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>イーズインアウト(&amp;U)</translation>
    </message>
    <message>
        <source>Selected strokes begin and end slowly</source>
        <translation>選択したストロークをゆっくり始めてゆっくり終えます</translation>
    </message>
    <message>
        <source>Export Ti&amp;melapse…</source>
        <translation>タイムラプスをエクスポート(&amp;M)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+E</source>
        <translation>Ctrl+Alt+E</translation>
    </message>
    <message>
        <source>Make a film of the painting being painted</source>
        <translation>絵が描かれていく過程の動画を作ります</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>描くペース(&amp;C)</translation>
    </message>
    <message>
        <source>Relative to the Last Select&amp;ed</source>
        <translation>最後に選択したものを基準(&amp;E)</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File</source>
        <translation>取り消し履歴をファイルに残す(&amp;H)</translation>
    </message>
    <message>
        <source>Whoever opens the file can go on undoing. Take it out before you give a file away</source>
        <translation>ファイルを開いた人が、取り消しを続けられます。ファイルを渡す前には外してください</translation>
    </message>
    <message>
        <source>Import &amp;Underlay…</source>
        <translation>下絵をインポート(&amp;U)…</translation>
    </message>
    <message>
        <source>A picture to paint over, which shows on the canvas only</source>
        <translation>上から描くための画像。キャンバスにだけ表示されます</translation>
    </message>
    <message>
        <source>Show the Underl&amp;ay</source>
        <translation>下絵を表示(&amp;A)</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>&amp;Import Strokes…</source>
        <translation>ストロークをインポート(&amp;I)…</translation>
    </message>
    <message>
        <source>Drawings, recordings and the strokes of other paintings, into this one</source>
        <translation>ベクター画像、記録、ほかの絵のストロークを、この絵に取り込みます</translation>
    </message>
    <message>
        <source>S&amp;maller Tool Size</source>
        <translation>ツールサイズを小さく(&amp;M)</translation>
    </message>
    <message>
        <source>La&amp;rger Tool Size</source>
        <translation>ツールサイズを大きく(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Less Opacity</source>
        <translation>不透明度を下げる(&amp;L)</translation>
    </message>
    <message>
        <source>More &amp;Opacity</source>
        <translation>不透明度を上げる(&amp;O)</translation>
    </message>
    <message>
        <source>Move the Canvas While Held</source>
        <translation>押している間キャンバスを移動</translation>
    </message>
    <message>
        <source>Turn the Canvas While Held</source>
        <translation>押している間キャンバスを回転</translation>
    </message>
    <message>
        <source>Move the Selection</source>
        <translation>選択範囲を移動</translation>
    </message>
    <message>
        <source>Move the Selection Ten Times as Far</source>
        <translation>選択範囲を 10 倍の距離だけ移動</translation>
    </message>
    <message>
        <source>Move the Selection by One Unit</source>
        <translation>選択範囲を 1 単位移動</translation>
    </message>
    <message>
        <source>Move the Selection by Ten Units</source>
        <translation>選択範囲を 10 単位移動</translation>
    </message>
    <message>
        <source>Move Rows in the Strokes Dock</source>
        <translation>ストロークドックで行を移動</translation>
    </message>
    <message>
        <source>Previous Stroke or Node</source>
        <translation>前のストロークまたはノード</translation>
    </message>
    <message>
        <source>Give Up, or Deselect</source>
        <translation>中止、または選択を解除</translation>
    </message>
    <message>
        <source>Save a Cop&amp;y…</source>
        <translation>コピーを保存(&amp;Y)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Shift+S</source>
        <translation>Ctrl+Alt+Shift+S</translation>
    </message>
    <message>
        <source>Into another file; you go on painting in this one</source>
        <translation>別のファイルに保存し、このファイルで描き続けます</translation>
    </message>
    <message>
        <source>Re&amp;vert…</source>
        <translation>保存時の状態に戻す(&amp;V)…</translation>
    </message>
    <message>
        <source>Back to what the file holds; Undo takes it back</source>
        <translation>ファイルの内容に戻します。「元に戻す」で取り消せます</translation>
    </message>
    <message>
        <source>Restore &amp;Backup…</source>
        <translation>バックアップから復元(&amp;B)…</translation>
    </message>
    <message>
        <source>Back to an earlier version of the file</source>
        <translation>ファイルの以前のバージョンに戻します</translation>
    </message>
    <message>
        <source>Export A&amp;gain</source>
        <translation>再エクスポート(&amp;G)</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>To the same file, with the same settings</source>
        <translation>同じファイルに、同じ設定でエクスポートします</translation>
    </message>
    <message>
        <source>Hide Outlines and Handles While Held</source>
        <translation>押している間アウトラインとハンドルを隠す</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名前(&amp;N)</translation>
    </message>
    <message>
        <source>Select all strokes of the same name</source>
        <translation>同じ名前のストロークをすべて選択します</translation>
    </message>
    <message>
        <source>Select &amp;Found</source>
        <translation>検索結果を選択(&amp;F)</translation>
    </message>
    <message>
        <source>Select what the search in the Strokes dock has found</source>
        <translation>ストロークドックの検索で見つかったものを選択します</translation>
    </message>
    <message>
        <source>Find Strokes</source>
        <translation>ストロークを検索</translation>
    </message>
    <message>
        <source>Look for strokes and groups by their names, in the Strokes dock</source>
        <translation>ストロークとグループを、ストロークドックで名前から探します</translation>
    </message>
    <message>
        <source>Show Ou&amp;tlines</source>
        <translation>アウトラインを表示(&amp;T)</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>Lines along the selected strokes; the Brush shows none</source>
        <translation>選択したストロークに沿った線。ブラシツールでは表示されません</translation>
    </message>
    <message>
        <source>Show Paint &amp;beyond the Canvas</source>
        <translation>キャンバス外の絵の具を表示(&amp;B)</translation>
    </message>
    <message>
        <source>Under a veil, what was painted beside the canvas; it is in no picture that is exported</source>
        <translation>キャンバスの外に描いたものを薄く表示します。エクスポートした画像には入りません</translation>
    </message>
    <message>
        <source>Ne&amp;xt Panel</source>
        <translation>次のパネル(&amp;X)</translation>
    </message>
    <message>
        <source>The keyboard goes from the canvas to the docks and tool bars in turn</source>
        <translation>キーボードフォーカスを、キャンバスからドックとツールバーへ順に移します</translation>
    </message>
    <message>
        <source>&amp;Previous Panel</source>
        <translation>前のパネル(&amp;P)</translation>
    </message>
    <message>
        <source>The keyboard goes back from panel to panel</source>
        <translation>キーボードフォーカスを、前のパネルに戻します</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>元に戻す(&amp;U): %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>やり直す(&amp;R): %1</translation>
    </message>
    <message>
        <source>&amp;Find a Command…</source>
        <translation>コマンドを検索(&amp;F)…</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>Commands, brushes, docks and recent files by their names</source>
        <translation>コマンド、ブラシ、ドック、最近使ったファイルを名前から探します</translation>
    </message>
    <message>
        <source>Drawing pace</source>
        <translation>描くペース</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>一時停止(&amp;P)</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>濡らし直しを削除</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>グリッド</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>間隔</translation>
    </message>
    <message>
        <source>Keep Undo &amp;History in the File (%1)</source>
        <translation>取り消し履歴をファイルに残す(&amp;H)（%1）</translation>
    </message>
    <message>
        <source>Canvas, while held</source>
        <translation>キャンバス、押している間</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>どこでも</translation>
    </message>
    <message>
        <source>Canvas, Strokes dock</source>
        <translation>キャンバス、ストロークドック</translation>
    </message>
    <message>
        <source>Canvas, Timeline dock</source>
        <translation>キャンバス、タイムラインドック</translation>
    </message>
    <message>
        <source>Canvas, Segments tool</source>
        <translation>キャンバス、セグメントツール</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>Nothing is wet at this moment.</source>
        <translation>この時点で濡れているものはありません。</translation>
    </message>
    <message>
        <source>Freeze wet paint</source>
        <translation>濡れた絵の具を固定</translation>
    </message>
    <message>
        <source>Nothing that is selected is painted yet at this moment.</source>
        <translation>選択したものは、この時点ではまだ描かれていません。</translation>
    </message>
    <message>
        <source>Name of the group</source>
        <translation>グループの名前</translation>
    </message>
    <message numerus="yes">
        <source>Name of %Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本の名前</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>名前を変更</translation>
    </message>
    <message>
        <source>Re-wet</source>
        <translation>濡らし直す</translation>
    </message>
    <message>
        <source>Seconds that the paint spreads on</source>
        <translation>絵の具がさらに広がる秒数</translation>
    </message>
    <message>
        <source>Ctrl+Shift+L</source>
        <translation>Ctrl+Shift+L</translation>
    </message>
    <message>
        <source>Smooth the curves of the selected strokes; each time more</source>
        <translation>選択したストロークの曲線を滑らかにします。繰り返すほど強まります</translation>
    </message>
    <message>
        <source>S&amp;traighten</source>
        <translation>直線に近づける(&amp;T)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+L</source>
        <translation>Ctrl+Alt+L</translation>
    </message>
    <message>
        <source>Move the selected strokes towards straight lines; each time more</source>
        <translation>選択したストロークを直線に近づけます。繰り返すほど強まります</translation>
    </message>
    <message>
        <source>&amp;Grow Paint</source>
        <translation>絵の具を太く(&amp;G)</translation>
    </message>
    <message>
        <source>Ctrl+)</source>
        <translation>Ctrl+)</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes wider</source>
        <translation>選択したストロークの絵の具を太くします</translation>
    </message>
    <message>
        <source>S&amp;hrink Paint</source>
        <translation>絵の具を細く(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+(</source>
        <translation>Ctrl+(</translation>
    </message>
    <message>
        <source>Make the paint of the selected strokes narrower</source>
        <translation>選択したストロークの絵の具を細くします</translation>
    </message>
    <message>
        <source>What is selected is locked or hidden.</source>
        <translation>選択したものはロックされているか、非表示です。</translation>
    </message>
    <message>
        <source>Simp&amp;lify…</source>
        <translation>簡略化(&amp;L)…</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>Make fewer segments of the selected strokes</source>
        <translation>選択したストロークのセグメントを減らします</translation>
    </message>
    <message>
        <source>&amp;Offset and More…</source>
        <translation>オフセットなど(&amp;O)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+O</source>
        <translation>Ctrl+Alt+O</translation>
    </message>
    <message>
        <source>Offset, smooth, straighten, grow or shrink the selected strokes by numbers</source>
        <translation>選択したストロークを、数値指定でオフセット、平滑化、直線化、または太く・細くします</translation>
    </message>
    <message>
        <source>Resha&amp;pe</source>
        <translation>形の調整(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>塗り(&amp;F)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Wet what the selected strokes enclose; the inspector has its values</source>
        <translation>選択したストロークで囲まれた部分を濡らして塗ります。値はインスペクターにあります</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>塗り</translation>
    </message>
    <message>
        <source>Remove Fill</source>
        <translation>塗りを削除</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>塗りを削除</translation>
    </message>
    <message>
        <source>Leave of the selected strokes their outlines</source>
        <translation>選択したストロークのアウトラインだけを残します</translation>
    </message>
    <message>
        <source>Geome&amp;tric Shapes</source>
        <translation>図形(&amp;T)</translation>
    </message>
    <message>
        <source>Paint rectangles, ellipses, polygons and stars</source>
        <translation>長方形、楕円、多角形、星形を描きます</translation>
    </message>
    <message>
        <source>Redra&amp;w</source>
        <translation>描き直し(&amp;W)</translation>
    </message>
    <message>
        <source>Draw over a part of a stroke, which follows the new line</source>
        <translation>ストロークの一部の上に描くと、その部分が新しい線に変わります</translation>
    </message>
    <message>
        <source>&amp;Push</source>
        <translation>押す(&amp;P)</translation>
    </message>
    <message>
        <source>Push, comb, pinch or roughen strokes</source>
        <translation>ストロークを押したり、とかしたり、つまんだり、荒らしたりします</translation>
    </message>
    <message>
        <source>What lies under the pointer, and what can be done with it</source>
        <translation>ポインターの下にあるものと、それに対してできること</translation>
    </message>
    <message>
        <source>Br&amp;ush Palette at the Pointer</source>
        <translation>ポインター位置にブラシパレット(&amp;U)</translation>
    </message>
    <message>
        <source>Brushes, colours, size and zoom where the pointer is</source>
        <translation>ブラシ、色、サイズ、ズームをポインターの位置に表示します</translation>
    </message>
    <message>
        <source>Edit Value&amp;s Here…</source>
        <translation>ここで値を編集(&amp;S)…</translation>
    </message>
    <message>
        <source>Width, diffusion, density, colour and opacity of what is selected, at the pointer</source>
        <translation>選択したものの幅、拡散、濃度、色、不透明度をポインターの位置で編集します</translation>
    </message>
    <message>
        <source>&amp;Whole Brush</source>
        <translation>ブラシ全体(&amp;W)</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>Put the brush in hand on the selected strokes; they remember the pen&apos;s pressure</source>
        <translation>使用中のブラシを、選択したストロークに適用します。ペンの筆圧は保たれます</translation>
    </message>
    <message>
        <source>&amp;Form Only</source>
        <translation>形状のみ(&amp;F)</translation>
    </message>
    <message>
        <source>Width, density, tapering and tip of the brush in hand</source>
        <translation>使用中のブラシの幅、濃度、入り抜き、筆先を適用します</translation>
    </message>
    <message>
        <source>&amp;Colour Only</source>
        <translation>色のみ(&amp;C)</translation>
    </message>
    <message>
        <source>Colour and opacity of the brush in hand</source>
        <translation>使用中のブラシの色と不透明度を適用します</translation>
    </message>
    <message>
        <source>&amp;Texture Only</source>
        <translation>テクスチャのみ(&amp;T)</translation>
    </message>
    <message>
        <source>Style, mixing, grain and drying time of the brush in hand</source>
        <translation>使用中のブラシのスタイル、混色、紙目、乾燥時間を適用します</translation>
    </message>
    <message>
        <source>C&amp;opy Appearance</source>
        <translation>外観をコピー(&amp;O)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+C</source>
        <translation>Ctrl+Shift+C</translation>
    </message>
    <message>
        <source>Copy style, mixing, values and colour of the stroke that was selected last</source>
        <translation>最後に選択したストロークのスタイル、混色、値、色をコピーします</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Shift+V</translation>
    </message>
    <message>
        <source>Put it on the selected strokes; what varies along them goes on varying</source>
        <translation>選択したストロークに適用します。ストロークに沿った変化は残ります</translation>
    </message>
    <message>
        <source>Paste Appearance Evenl&amp;y</source>
        <translation>外観を均一に貼り付け(&amp;Y)</translation>
    </message>
    <message>
        <source>Put it on the selected strokes, with the same values all along</source>
        <translation>選択したストロークに、全体を同じ値にして適用します</translation>
    </message>
    <message>
        <source>Along th&amp;e Stroke…</source>
        <translation>ストロークに沿って(&amp;E)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+R</source>
        <translation>Ctrl+Alt+R</translation>
    </message>
    <message>
        <source>Set a value along the stroke: constant, as a ramp, or drawn as a curve</source>
        <translation>ストロークに沿った値を、一定、直線変化、または手描きの曲線で設定します</translation>
    </message>
    <message>
        <source>Vary at Rand&amp;om…</source>
        <translation>ランダムに変化(&amp;O)…</translation>
    </message>
    <message>
        <source>Ctrl+Alt+Y</source>
        <translation>Ctrl+Alt+Y</translation>
    </message>
    <message>
        <source>Let values and colours of the selected strokes stray at random</source>
        <translation>選択したストロークの値と色をランダムにばらつかせます</translation>
    </message>
    <message>
        <source>Appl&amp;y Brush</source>
        <translation>ブラシを適用(&amp;Y)</translation>
    </message>
    <message>
        <source>Show Erasures</source>
        <translation>消し跡を表示</translation>
    </message>
    <message>
        <source>Shift+E</source>
        <translation>Shift+E</translation>
    </message>
    <message>
        <source>Dashed lines along what was erased softly from all strokes; what is not selected is paler</source>
        <translation>すべてのストロークからやわらかく消した所を破線で示します。選択されていないものは薄くなります</translation>
    </message>
    <message>
        <source>&amp;Combine</source>
        <translation>連結(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+K</source>
        <translation>Ctrl+Alt+K</translation>
    </message>
    <message>
        <source>Make one stroke of the selected ones, whose paint adds up</source>
        <translation>選択したストロークを 1 本にまとめ、絵の具を加算します</translation>
    </message>
    <message>
        <source>Break Apart</source>
        <translation>分解</translation>
    </message>
    <message>
        <source>Ctrl+Shift+K</source>
        <translation>Ctrl+Shift+K</translation>
    </message>
    <message>
        <source>Make strokes of the parts of the selected ones</source>
        <translation>選択したストロークの各部分を別々のストロークにします</translation>
    </message>
    <message>
        <source>Remove Erasures</source>
        <translation>消し跡を削除</translation>
    </message>
    <message>
        <source>Bring back what was erased softly from the selected strokes, or by the selected segments</source>
        <translation>選択したストローク、または選択したセグメントによってやわらかく消したものを元に戻します</translation>
    </message>
    <message>
        <source>Delete the selected segments, which leaves gaps in strokes</source>
        <translation>選択したセグメントを削除します。ストロークに切れ目ができます</translation>
    </message>
    <message>
        <source>Take paint away softly, or cut out parts of strokes</source>
        <translation>絵の具をやわらかく取り除くか、ストロークの一部を切り抜きます</translation>
    </message>
    <message>
        <source>Map Colours to S&amp;watches</source>
        <translation>色をスウォッチに置き換え(&amp;W)</translation>
    </message>
    <message>
        <source>Give what is selected, or else all of the painting, the swatches that look nearest</source>
        <translation>選択したもの、または絵全体の色を、最も近く見えるスウォッチにします</translation>
    </message>
    <message>
        <source>Ctrl+Alt+C</source>
        <translation>Ctrl+Alt+C</translation>
    </message>
    <message>
        <source>Give each colour of the painting, or of what is selected, another one everywhere</source>
        <translation>絵または選択したものの色を、それぞれ別の色にまとめて変更します</translation>
    </message>
    <message>
        <source>Paste Appeara&amp;nce</source>
        <translation>外観を貼り付け(&amp;N)</translation>
    </message>
    <message>
        <source>Menu at t&amp;he Pointer</source>
        <translation>ポインター位置にメニュー(&amp;H)</translation>
    </message>
    <message>
        <source>Recolour Artwor&amp;k…</source>
        <translation>アートワークを再配色(&amp;K)…</translation>
    </message>
    <message>
        <source>Match &amp;by Eyedropper</source>
        <translation>スポイトで外観を合わせる(&amp;B)</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its style, mixing, values and colour</source>
        <translation>ストロークをクリックすると、そのスタイル、混色、値、色が選択したものに付きます</translation>
    </message>
    <message>
        <source>A fill cannot be wetted again. It spreads as long as it takes to dry.</source>
        <translation>塗りは濡らし直せません。乾くまでの間だけ広がります。</translation>
    </message>
    <message>
        <source>Not done: nothing would be left.</source>
        <translation>実行しませんでした。実行すると何も残りません。</translation>
    </message>
    <message>
        <source>Not done: the outlines meet so often that it would take minutes.</source>
        <translation>実行しませんでした。アウトラインの交差が多すぎて、何分もかかります。</translation>
    </message>
    <message>
        <source>Not done: the outlines lie on each other so closely that the result is uncertain.</source>
        <translation>実行しませんでした。アウトラインが近すぎて、結果が不確かになります。</translation>
    </message>
    <message>
        <source>Select two or more filled strokes.</source>
        <translation>塗りのあるストロークを 2 本以上選択してください。</translation>
    </message>
    <message>
        <source>&amp;Union</source>
        <translation>統合(&amp;U)</translation>
    </message>
    <message>
        <source>Ctrl+Alt++</source>
        <translation>Ctrl+Alt++</translation>
    </message>
    <message>
        <source>One fill of what the selected ones cover, with the values of the lowest</source>
        <translation>選択したものが覆う範囲を 1 つの塗りにします。値は一番下のものになります</translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation>差分(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+-</source>
        <translation>Ctrl+Alt+-</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what the others do not cover</source>
        <translation>選択した一番下の塗りから、ほかが覆う部分を除きます</translation>
    </message>
    <message>
        <source>&amp;Intersection</source>
        <translation>交差(&amp;I)</translation>
    </message>
    <message>
        <source>Ctrl+*</source>
        <translation>Ctrl+*</translation>
    </message>
    <message>
        <source>Leave of the lowest selected fill what all others cover</source>
        <translation>選択した一番下の塗りのうち、ほかのすべてが覆う部分を残します</translation>
    </message>
    <message>
        <source>E&amp;xclusion</source>
        <translation>排他(&amp;X)</translation>
    </message>
    <message>
        <source>Ctrl+^</source>
        <translation>Ctrl+^</translation>
    </message>
    <message>
        <source>One fill of what one of the selected ones covers, and not two</source>
        <translation>選択したもののうち 1 つだけが覆う部分を 1 つの塗りにします</translation>
    </message>
    <message>
        <source>Di&amp;vision</source>
        <translation>分割(&amp;V)</translation>
    </message>
    <message>
        <source>Ctrl+/</source>
        <translation>Ctrl+/</translation>
    </message>
    <message>
        <source>Cut the lowest selected fill along the outlines of the others</source>
        <translation>選択した一番下の塗りを、ほかのアウトラインで切り分けます</translation>
    </message>
    <message>
        <source>Select a filled stroke.</source>
        <translation>塗りのあるストロークを選択してください。</translation>
    </message>
    <message>
        <source>I&amp;nset</source>
        <translation>インセット(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+(</source>
        <translation>Ctrl+Alt+(</translation>
    </message>
    <message>
        <source>Move the outlines of fills inwards, by the distance of Offset and More</source>
        <translation>塗りのアウトラインを「オフセットなど」の距離だけ内側へ動かします</translation>
    </message>
    <message>
        <source>&amp;Outset</source>
        <translation>アウトセット(&amp;O)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+)</source>
        <translation>Ctrl+Alt+)</translation>
    </message>
    <message>
        <source>Move the outlines of fills outwards, by the distance of Offset and More</source>
        <translation>塗りのアウトラインを「オフセットなど」の距離だけ外側へ動かします</translation>
    </message>
    <message>
        <source>&amp;Stroke to Outline</source>
        <translation>ストロークをアウトラインに変換(&amp;S)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+T</source>
        <translation>Ctrl+Alt+T</translation>
    </message>
    <message>
        <source>Make fills of what is seen of the lines of the selected strokes</source>
        <translation>選択したストロークの見えている線を塗りに変換します</translation>
    </message>
    <message>
        <source>Stroke to outline</source>
        <translation>ストロークをアウトラインに変換</translation>
    </message>
    <message>
        <source>Select a stroke of which a line is seen.</source>
        <translation>線が見えているストロークを選択してください。</translation>
    </message>
    <message>
        <source>Areas</source>
        <translation>領域の演算</translation>
    </message>
    <message>
        <source>Outline Pe&amp;n</source>
        <translation>アウトラインペン(&amp;N)</translation>
    </message>
    <message>
        <source>Draw an outline node by node, filled or not</source>
        <translation>ノードを 1 つずつ置いてアウトラインを描きます。塗りの有無は選べます</translation>
    </message>
    <message>
        <source>Lasso F&amp;ill</source>
        <translation>投げ縄塗り(&amp;I)</translation>
    </message>
    <message>
        <source>Fill what is drawn around</source>
        <translation>囲んだ部分を塗りつぶします</translation>
    </message>
    <message>
        <source>Bu&amp;cket</source>
        <translation>バケツ(&amp;C)</translation>
    </message>
    <message>
        <source>Fill what the paint around a place bounds</source>
        <translation>絵の具で囲まれた部分を塗りつぶします</translation>
    </message>
    <message>
        <source>Text to Strokes</source>
        <translation>テキストをストロークに変換</translation>
    </message>
    <message>
        <source>Make plain strokes of the letters of the selected texts; they cannot be typed in any more</source>
        <translation>選択したテキストの文字を通常のストロークにします。文字の入力はできなくなります</translation>
    </message>
    <message>
        <source>Text to strokes</source>
        <translation>テキストをストロークに変換</translation>
    </message>
    <message>
        <source>Release Text from Stroke</source>
        <translation>テキストをストロークから切り離す</translation>
    </message>
    <message>
        <source>Let the selected texts keep their curves, whatever becomes of the strokes that they follow</source>
        <translation>選択したテキストは、追従するストロークがどう変わっても今の曲線を保ちます</translation>
    </message>
    <message>
        <source>Select a text that follows a stroke.</source>
        <translation>ストロークに追従するテキストを選択してください。</translation>
    </message>
    <message>
        <source>Release text from stroke</source>
        <translation>テキストをストロークから切り離す</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>テキスト(&amp;X)</translation>
    </message>
    <message>
        <source>Type texts, whose letters are strokes</source>
        <translation>テキストを入力。文字はストロークになります</translation>
    </message>
    <message>
        <source>&amp;Zoom to Selection</source>
        <translation>選択範囲にズーム(&amp;Z)</translation>
    </message>
    <message>
        <source>Ctrl+0</source>
        <translation>Ctrl+0</translation>
    </message>
    <message>
        <source>Show what is selected as large as possible: strokes, segments or nodes</source>
        <translation>選択したもの（ストローク、セグメント、ノード）をできるだけ大きく表示します</translation>
    </message>
    <message>
        <source>Add Gradient</source>
        <translation>グラデーションを追加</translation>
    </message>
    <message>
        <source>The colour of the selected fills fades from left to right; needs a fill of one colour</source>
        <translation>選択した塗りの色を左から右へ変化させます。単色の塗りが必要です</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>グラデーションを追加</translation>
    </message>
    <message>
        <source>Remove Gradient</source>
        <translation>グラデーションを削除</translation>
    </message>
    <message>
        <source>The selected fills have their first colour everywhere; needs a fill with a gradient</source>
        <translation>選択した塗り全体を最初の色にします。グラデーションの塗りが必要です</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>グラデーションを削除</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>下でクリッピング</translation>
    </message>
    <message>
        <source>Ctrl+Alt+G</source>
        <translation>Ctrl+Alt+G</translation>
    </message>
    <message>
        <source>The selected groups are seen only where the next thing below them in the same group is; needs something below</source>
        <translation>選択したグループを、同じグループ内ですぐ下にあるものの範囲でだけ表示します。下に何かが必要です</translation>
    </message>
    <message>
        <source>Use as Mask</source>
        <translation>マスクとして使用</translation>
    </message>
    <message>
        <source>What is beside the selected groups is seen only where they have paint; needs something beside</source>
        <translation>選択したグループと同じ階層のものを、グループに絵の具がある所でだけ表示します。同じ階層にほかのものが必要です</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>ウォッシュ</translation>
    </message>
    <message>
        <source>The strokes of the selected groups are one, laid wet into wet</source>
        <translation>選択したグループのストロークを、ウェットインウェットで一体にします</translation>
    </message>
    <message>
        <source>What the group did as a whole (opacity, mode, isolation, clip, mask, wash) is gone with it.</source>
        <translation>グループ全体の効果（不透明度、合成モード、単独での混色、クリッピング、マスク、ウォッシュ）も、グループと一緒になくなります。</translation>
    </message>
    <message>
        <source>Group as a Whole</source>
        <translation>グループ全体</translation>
    </message>
    <message>
        <source>Not merged: nothing lies below the layer in its group.</source>
        <translation>結合できません。グループ内でこのレイヤーの下に何もありません。</translation>
    </message>
    <message>
        <source>Not merged: what lies just below the layer is no layer.</source>
        <translation>結合できません。すぐ下にあるものがレイヤーではありません。</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is hidden.</source>
        <translation>結合できません。一方のレイヤーが非表示です。</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is locked.</source>
        <translation>結合できません。一方のレイヤーがロックされています。</translation>
    </message>
    <message>
        <source>Merge layer down</source>
        <translation>下のレイヤーと結合</translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation>レイヤーを複製</translation>
    </message>
    <message>
        <source>Raise layer</source>
        <translation>レイヤーを上へ</translation>
    </message>
    <message>
        <source>Lower layer</source>
        <translation>レイヤーを下へ</translation>
    </message>
    <message>
        <source>&amp;New Layer</source>
        <translation>新規レイヤー(&amp;N)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+N</source>
        <translation>Ctrl+Shift+N</translation>
    </message>
    <message>
        <source>Paint on a new layer above this one; it comes with its first stroke</source>
        <translation>このレイヤーの上の新しいレイヤーに描きます。最初のストロークと同時に作られます</translation>
    </message>
    <message>
        <source>New &amp;Clipped Layer</source>
        <translation>新規クリッピングレイヤー(&amp;C)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+N</source>
        <translation>Ctrl+Alt+N</translation>
    </message>
    <message>
        <source>Paint on a new layer that shows only where the layer below has paint: a clipping mask</source>
        <translation>下のレイヤーに絵の具がある所でだけ見える、新しいレイヤーに描きます（クリッピングマスク）</translation>
    </message>
    <message>
        <source>&amp;Duplicate Layer</source>
        <translation>レイヤーを複製(&amp;D)</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>下のレイヤーと結合(&amp;M)</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>&amp;Raise Layer</source>
        <translation>レイヤーを上へ(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Lower Layer</source>
        <translation>レイヤーを下へ(&amp;L)</translation>
    </message>
    <message>
        <source>Layer &amp;Above</source>
        <translation>上のレイヤーを選ぶ(&amp;A)</translation>
    </message>
    <message>
        <source>Paint on the next layer above; above all of them there is none</source>
        <translation>1 つ上のレイヤーに描きます。一番上の次はレイヤーなしになります</translation>
    </message>
    <message>
        <source>Layer &amp;Below</source>
        <translation>下のレイヤーを選ぶ(&amp;B)</translation>
    </message>
    <message>
        <source>Paint on the next layer below</source>
        <translation>1 つ下のレイヤーに描きます</translation>
    </message>
    <message>
        <source>N&amp;o Layer</source>
        <translation>レイヤーなし(&amp;O)</translation>
    </message>
    <message>
        <source>Paint on top of all again</source>
        <translation>再び全体の一番上に描きます</translation>
    </message>
    <message>
        <source>&amp;Hide Others</source>
        <translation>ほかを隠す(&amp;H)</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>Show only this layer, or all again</source>
        <translation>このレイヤーだけを表示するか、すべて再表示します</translation>
    </message>
    <message>
        <source>Show other layers</source>
        <translation>ほかのレイヤーを表示</translation>
    </message>
    <message>
        <source>Hide other layers</source>
        <translation>ほかのレイヤーを隠す</translation>
    </message>
    <message>
        <source>&amp;Layer</source>
        <translation>レイヤー(&amp;L)</translation>
    </message>
    <message>
        <source>Nothing changes.</source>
        <translation>何も変わりません。</translation>
    </message>
    <message>
        <source>Not merged: one of the two layers is a mask, and the picture would change.</source>
        <translation>結合できません。一方のレイヤーがマスクで、見た目が変わってしまいます。</translation>
    </message>
    <message>
        <source>Not merged: the layer below is clipped, and the picture would change.</source>
        <translation>結合できません。下のレイヤーがクリッピングされており、見た目が変わってしまいます。</translation>
    </message>
    <message>
        <source>Not merged: what lies above is clipped to this layer, and the picture would change.</source>
        <translation>結合できません。上のものがこのレイヤーでクリッピングされており、見た目が変わってしまいます。</translation>
    </message>
    <message>
        <source>So that the picture stays, %1 is a group of its own within %2.</source>
        <translation>見た目を保つため、%1 は %2 の中の独立したグループになります。</translation>
    </message>
    <message>
        <source>Put the layer onto the one just below it; the picture stays</source>
        <translation>レイヤーをすぐ下のレイヤーに結合します。見た目は変わりません</translation>
    </message>
    <message>
        <source>La&amp;yer</source>
        <translation>レイヤー(&amp;Y)</translation>
    </message>
    <message>
        <source>&amp;This Layer Only</source>
        <translation>このレイヤーのみ(&amp;T)</translation>
    </message>
    <message>
        <source>Tools reach only what is on the layer, where there is one</source>
        <translation>レイヤーがあるとき、ツールの対象をレイヤー上のものに限ります</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>下描き</translation>
    </message>
    <message>
        <source>The selected groups are seen here, and left out of what is exported</source>
        <translation>選択したグループはここでは見え、エクスポートには含まれません</translation>
    </message>
    <message>
        <source>Underlay to Layer</source>
        <translation>下絵をレイヤーに変換</translation>
    </message>
    <message>
        <source>Make an image layer below all of the underlay, where it lies; it is exported then</source>
        <translation>下絵を、その位置のまま一番下の画像レイヤーにします。エクスポートに含まれるようになります</translation>
    </message>
    <message>
        <source>Picture to Stro&amp;kes…</source>
        <translation>画像をストロークに変換(&amp;K)…</translation>
    </message>
    <message>
        <source>Strokes that look like a picture, of a file or the underlay, as a layer</source>
        <translation>ファイルまたは下絵の画像に似たストロークを、レイヤーとして作ります</translation>
    </message>
    <message>
        <source>Import &amp;Picture as Layer…</source>
        <translation>画像をレイヤーとしてインポート(&amp;P)…</translation>
    </message>
    <message>
        <source>A picture as a layer among the others: with opacity and mode, and in what is exported</source>
        <translation>画像をほかと並ぶレイヤーにします。不透明度と合成モードを持ち、エクスポートに含まれます</translation>
    </message>
    <message>
        <source>Paste strokes, SVG paths or a picture at the pointer; a colour becomes the current one</source>
        <translation>ストローク、SVG パス、画像をポインターの位置に貼り付けます。色は現在の色になります</translation>
    </message>
    <message>
        <source>Export &amp;Drawing…</source>
        <translation>ベクター画像をエクスポート(&amp;D)…</translation>
    </message>
    <message>
        <source>Prin&amp;t…</source>
        <translation>印刷(&amp;T)…</translation>
    </message>
    <message>
        <source>On paper, or as a page of a PDF file</source>
        <translation>紙に、または PDF ファイルの 1 ページとして印刷します</translation>
    </message>
    <message>
        <source>Print Previe&amp;w…</source>
        <translation>印刷プレビュー(&amp;W)…</translation>
    </message>
    <message>
        <source>See the page in large before it is printed</source>
        <translation>印刷する前にページを大きく表示します</translation>
    </message>
    <message>
        <source>Exact outlines and bands of paint for Inkscape, plotters and browsers (SVG)</source>
        <translation>Inkscape、プロッター、ブラウザー用の正確なアウトラインと絵の具の帯（SVG）</translation>
    </message>
    <message>
        <source>Soft Proof</source>
        <translation>ソフトプルーフ</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Y</source>
        <translation>Ctrl+Shift+Y</translation>
    </message>
    <message>
        <source>Shows the colours that are left on another device, as a press, by its profile</source>
        <translation>印刷機など、ほかの機器で再現される色を、そのプロファイルで表示します</translation>
    </message>
    <message>
        <source>Gamut &amp;Warning</source>
        <translation>色域外警告(&amp;W)</translation>
    </message>
    <message>
        <source>Marks the colours that the device of the soft proof does not have</source>
        <translation>ソフトプルーフの機器で再現できない色に印を付けます</translation>
    </message>
    <message>
        <source>Soft Proof with Profile…</source>
        <translation>プロファイルを選んでソフトプルーフ…</translation>
    </message>
    <message>
        <source>Chooses the profile of the device whose colours are shown</source>
        <translation>色を再現する機器のプロファイルを選びます</translation>
    </message>
    <message>
        <source>It is clipped to a layer that is hidden now, so nothing of it is seen.</source>
        <translation>クリッピング先のレイヤーが今は非表示のため、何も見えません。</translation>
    </message>
    <message>
        <source>&amp;Fewer Strokes…</source>
        <translation>ストロークを減らす(&amp;F)…</translation>
    </message>
    <message>
        <source>Make fewer strokes that look like the selected ones</source>
        <translation>選択したものに似た、より少ないストロークを作ります</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>マニュアル(&amp;M)</translation>
    </message>
    <message>
        <source>What Suffuse does and how; the key opens the page about what you are working with</source>
        <translation>Suffuse でできることとその方法。キーを押すと、使っているものについてのページが開きます</translation>
    </message>
    <message>
        <source>Ctrl+F1</source>
        <translation>Ctrl+F1</translation>
    </message>
    <message>
        <source>&amp;Welcome…</source>
        <translation>ようこそ(&amp;W)…</translation>
    </message>
    <message>
        <source>New paintings, recent ones, samples, and short lessons</source>
        <translation>新しい絵、最近使った絵、サンプル、短いレッスン</translation>
    </message>
    <message>
        <source>Nothing is selected: click paint with Select first.</source>
        <translation>何も選択されていません。先に選択ツールで絵の具をクリックしてください。</translation>
    </message>
    <message>
        <source>Nothing is painted yet.</source>
        <translation>まだ何も描かれていません。</translation>
    </message>
    <message>
        <source>Nothing is locked.</source>
        <translation>ロックされたものはありません。</translation>
    </message>
    <message>
        <source>Nothing is hidden.</source>
        <translation>非表示のものはありません。</translation>
    </message>
    <message>
        <source>Select two strokes or more; to the canvas one can be aligned, too.</source>
        <translation>ストロークを 2 本以上選択してください。キャンバスに対しては 1 本でも整列できます。</translation>
    </message>
    <message>
        <source>No layer is chosen: click one in the Strokes dock, or begin one with New Layer.</source>
        <translation>レイヤーが選ばれていません。ストロークドックでクリックするか、「新規レイヤー」で作ってください。</translation>
    </message>
    <message>
        <source>The painting has no layers yet: New Layer begins one.</source>
        <translation>この絵にはまだレイヤーがありません。「新規レイヤー」で作れます。</translation>
    </message>
    <message>
        <source>Select a group that this can be.</source>
        <translation>これを設定できるグループを選択してください。</translation>
    </message>
    <message>
        <source>Select strokes of a group.</source>
        <translation>グループのストロークを選択してください。</translation>
    </message>
    <message>
        <source>Select a text.</source>
        <translation>テキストを選択してください。</translation>
    </message>
    <message>
        <source>Select strokes without a fill.</source>
        <translation>塗りのないストロークを選択してください。</translation>
    </message>
    <message>
        <source>Select a fill of one colour.</source>
        <translation>単色の塗りを選択してください。</translation>
    </message>
    <message>
        <source>Select a fill with a gradient.</source>
        <translation>グラデーションの塗りを選択してください。</translation>
    </message>
    <message>
        <source>Select two strokes or more.</source>
        <translation>ストロークを 2 本以上選択してください。</translation>
    </message>
    <message>
        <source>Select a stroke that was combined or cut into parts.</source>
        <translation>連結したストロークか、部分に切断したストロークを選択してください。</translation>
    </message>
    <message>
        <source>Select a stroke from which something was erased softly.</source>
        <translation>やわらかく消した部分のあるストロークを選択してください。</translation>
    </message>
    <message>
        <source>The painting has no underlay.</source>
        <translation>この絵には下絵がありません。</translation>
    </message>
    <message>
        <source>Select paint that was wetted again.</source>
        <translation>濡らし直した絵の具を選択してください。</translation>
    </message>
    <message>
        <source>Copy an appearance first.</source>
        <translation>先に外観をコピーしてください。</translation>
    </message>
    <message>
        <source>The painting has no swatches.</source>
        <translation>この絵にはスウォッチがありません。</translation>
    </message>
    <message>
        <source>The painting has no file yet: save it first.</source>
        <translation>この絵にはまだファイルがありません。先に保存してください。</translation>
    </message>
    <message>
        <source>The clipboard has nothing that can be painted.</source>
        <translation>クリップボードに、描けるものがありません。</translation>
    </message>
    <message>
        <source>An export is still under way.</source>
        <translation>エクスポートがまだ進行中です。</translation>
    </message>
    <message>
        <source>Search in the Strokes dock first.</source>
        <translation>先にストロークドックで検索してください。</translation>
    </message>
    <message>
        <source>Switch the soft proof on first.</source>
        <translation>先にソフトプルーフをオンにしてください。</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>元に戻すものがありません。</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>やり直すものがありません。</translation>
    </message>
    <message>
        <source>Select nodes with Segments first.</source>
        <translation>先にセグメントツールでノードを選択してください。</translation>
    </message>
    <message>
        <source>Select segments, or the nodes at their ends, with Segments first.</source>
        <translation>先にセグメントツールで、セグメントかその両端のノードを選択してください。</translation>
    </message>
    <message>
        <source>Select two end nodes with Segments first.</source>
        <translation>先にセグメントツールで端点ノードを 2 つ選択してください。</translation>
    </message>
    <message>
        <source>&amp;Show the Axes of the Symmetry</source>
        <translation>対称軸を表示(&amp;S)</translation>
    </message>
    <message>
        <source>Also the square that moves them and the disc that turns them</source>
        <translation>軸を動かす四角と、回転させる円も表示します</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>ガイド</translation>
    </message>
    <message>
        <source>Horizontal place</source>
        <translation>水平位置</translation>
    </message>
    <message>
        <source>Vertical place</source>
        <translation>垂直位置</translation>
    </message>
    <message>
        <source>Show the &amp;Rulers</source>
        <translation>ルーラーを表示(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Along the upper and the left edge; guides are dragged out of them, and back into them</source>
        <translation>上端と左端に表示します。ここからガイドを引き出し、ここへ戻します</translation>
    </message>
    <message>
        <source>Show the &amp;Guides</source>
        <translation>ガイドを表示(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Snap to Guides</source>
        <translation>ガイドにスナップ(&amp;S)</translation>
    </message>
    <message>
        <source>Nodes, shapes and what is moved; paint goes where the hand goes</source>
        <translation>ノード、図形、移動するものが対象。描く線は手の動きに従います</translation>
    </message>
    <message>
        <source>&amp;Lock the Guides</source>
        <translation>ガイドをロック(&amp;L)</translation>
    </message>
    <message>
        <source>They cannot be dragged, and new ones still can be made</source>
        <translation>ドラッグできなくなります。新しいガイドは作れます</translation>
    </message>
    <message>
        <source>Add a Le&amp;vel Guide…</source>
        <translation>水平ガイドを追加(&amp;V)…</translation>
    </message>
    <message>
        <source>Add an &amp;Upright Guide…</source>
        <translation>垂直ガイドを追加(&amp;U)…</translation>
    </message>
    <message>
        <source>Remove &amp;All Guides</source>
        <translation>すべてのガイドを削除(&amp;A)</translation>
    </message>
    <message>
        <source>S&amp;how the Assistants</source>
        <translation>補助定規を表示(&amp;H)</translation>
    </message>
    <message>
        <source>Nothing is led by those that are not seen</source>
        <translation>見えていない補助定規はストロークを導きません</translation>
    </message>
    <message>
        <source>&amp;Snap to Assistants</source>
        <translation>補助定規にスナップ(&amp;S)</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>A stroke of the Brush follows the assistant whose direction it begins with</source>
        <translation>ブラシのストロークは、描き始めの向きが合う補助定規に沿います</translation>
    </message>
    <message>
        <source>Remove &amp;All Assistants</source>
        <translation>すべての補助定規を削除(&amp;A)</translation>
    </message>
    <message>
        <source>There are no assistants.</source>
        <translation>補助定規がありません。</translation>
    </message>
    <message>
        <source>Assistants</source>
        <translation>補助定規</translation>
    </message>
    <message>
        <source>Lines, vanishing points and ellipses that lead strokes</source>
        <translation>ストロークを導く直線、消失点、楕円</translation>
    </message>
    <message>
        <source>Mirrored &amp;Left and Right</source>
        <translation>左右対称(&amp;L)</translation>
    </message>
    <message>
        <source>What is painted on one side of an upright axis comes on the other, too</source>
        <translation>垂直な軸の片側に描くと、反対側にも現れます</translation>
    </message>
    <message>
        <source>Mirrored &amp;Top and Bottom</source>
        <translation>上下対称(&amp;T)</translation>
    </message>
    <message>
        <source>What is painted above a level axis comes below it, too</source>
        <translation>水平な軸の上に描くと、下にも現れます</translation>
    </message>
    <message>
        <source>Mirrored &amp;Both Ways</source>
        <translation>上下左右対称(&amp;B)</translation>
    </message>
    <message>
        <source>What is painted comes in all four corners of a cross</source>
        <translation>描いたものが、十字の 4 つの区画すべてに現れます</translation>
    </message>
    <message>
        <source>&amp;Rotated around the Centre</source>
        <translation>中心のまわりに回転(&amp;R)</translation>
    </message>
    <message>
        <source>What is painted comes once in each arm around the centre</source>
        <translation>描いたものが、中心のまわりの各区画に 1 回ずつ現れます</translation>
    </message>
    <message>
        <source>&amp;Kaleidoscope</source>
        <translation>万華鏡(&amp;K)</translation>
    </message>
    <message>
        <source>What is painted comes in each arm around the centre, and mirrored beside it</source>
        <translation>描いたものが、中心のまわりの各区画と、その隣に鏡映しで現れます</translation>
    </message>
    <message>
        <source>&amp;Paint in Symmetry</source>
        <translation>対称に描く(&amp;P)</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Shift+M</translation>
    </message>
    <message>
        <source>Strokes, shapes and outlines come several times, mirrored or rotated, as one undo step</source>
        <translation>ストローク、図形、アウトラインを鏡映しや回転で複数描きます。1 回で元に戻せます</translation>
    </message>
    <message>
        <source>Number of &amp;Arms…</source>
        <translation>分割数(&amp;A)…</translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation>対称</translation>
    </message>
    <message>
        <source>Arms around the centre</source>
        <translation>中心のまわりの分割数</translation>
    </message>
    <message>
        <source>An&amp;gle of the Axes…</source>
        <translation>軸の角度(&amp;G)…</translation>
    </message>
    <message>
        <source>Degrees clockwise</source>
        <translation>角度（時計回り）</translation>
    </message>
    <message>
        <source>Axes to the &amp;Middle of the Canvas</source>
        <translation>軸をキャンバスの中央へ(&amp;M)</translation>
    </message>
    <message>
        <source>The centre of the symmetry lies in the middle again, and the axes are upright and level</source>
        <translation>対称の中心を中央に戻し、軸を垂直と水平にします</translation>
    </message>
    <message>
        <source>Rulers and Guides</source>
        <translation>ルーラーとガイド</translation>
    </message>
    <message>
        <source>Workspace to &amp;Paint</source>
        <translation>描画用ワークスペース(&amp;P)</translation>
    </message>
    <message>
        <source>Colour, brushes and strokes beside a wide canvas</source>
        <translation>広いキャンバスの横に、色、ブラシ、ストロークを並べます</translation>
    </message>
    <message>
        <source>Workspace to &amp;Refine</source>
        <translation>仕上げ用ワークスペース(&amp;R)</translation>
    </message>
    <message>
        <source>Inspector, strokes, history and colour</source>
        <translation>インスペクター、ストローク、履歴、色を並べます</translation>
    </message>
    <message>
        <source>Workspace for &amp;Time</source>
        <translation>時間用ワークスペース(&amp;T)</translation>
    </message>
    <message>
        <source>A high timeline, with inspector and strokes</source>
        <translation>縦に広いタイムラインと、インスペクター、ストロークを並べます</translation>
    </message>
    <message>
        <source>&amp;Save Workspace…</source>
        <translation>ワークスペースを保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Keep where docks and tool bars stand now, under a name</source>
        <translation>ドックとツールバーの今の配置を、名前を付けて残します</translation>
    </message>
    <message>
        <source>Workspaces</source>
        <translation>ワークスペース</translation>
    </message>
    <message>
        <source>Rulers in &amp;Canvas Units</source>
        <translation>ルーラーをキャンバス単位に(&amp;C)</translation>
    </message>
    <message>
        <source>Rulers in &amp;Millimetres</source>
        <translation>ルーラーをミリメートルに(&amp;M)</translation>
    </message>
    <message>
        <source>Rulers in &amp;Inches</source>
        <translation>ルーラーをインチに(&amp;I)</translation>
    </message>
    <message>
        <source>New View</source>
        <translation>新しいビュー</translation>
    </message>
    <message>
        <source>A window that shows the painting from elsewhere while you paint; each edit shows in both</source>
        <translation>描きながら絵の別の場所を見るウィンドウです。編集はどちらにも反映されます</translation>
    </message>
    <message>
        <source>&amp;Repeat Last Extension</source>
        <translation>最後の拡張機能を繰り返す(&amp;R)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+X</source>
        <translation>Ctrl+Alt+X</translation>
    </message>
    <message>
        <source>Once more, with the same values</source>
        <translation>同じ値でもう一度実行します</translation>
    </message>
    <message>
        <source>&amp;Manage Extensions…</source>
        <translation>拡張機能を管理(&amp;M)…</translation>
    </message>
    <message>
        <source>Which extensions there are, which are in the menu, and what went wrong</source>
        <translation>拡張機能の一覧、メニューに出すもの、起きた問題</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected.</source>
        <translation>表示されていてロックされていないものが、選択されていません。</translation>
    </message>
    <message>
        <source>E&amp;xtensions</source>
        <translation>拡張機能(&amp;X)</translation>
    </message>
    <message>
        <source>%1…</source>
        <translation>%1…</translation>
    </message>
    <message>
        <source>Paint with Ke&amp;ys</source>
        <translation>キーで描く(&amp;Y)</translation>
    </message>
    <message>
        <source>Ctrl+Alt+P</source>
        <translation>Ctrl+Alt+P</translation>
    </message>
    <message>
        <source>Arrow keys move a crosshair over the canvas, Space presses the tool in use down and lifts it</source>
        <translation>矢印キーでキャンバス上の十字カーソルを動かし、Space で使用中のツールを押し下げ、離します</translation>
    </message>
    <message>
        <source>There are no guides.</source>
        <translation>ガイドがありません。</translation>
    </message>
    <message>
        <source>Choose a symmetry that turns, or the kaleidoscope, first.</source>
        <translation>先に回転対称か万華鏡を選んでください。</translation>
    </message>
    <message>
        <source>No extension has run yet.</source>
        <translation>まだ拡張機能を実行していません。</translation>
    </message>
</context>
<context>
    <name>suffuse::CompareButton</name>
    <message>
        <source>Before</source>
        <translation>変更前</translation>
    </message>
    <message>
        <source>Shows the picture as it was before the last changes to the selection: while held, or click to switch back and forth.</source>
        <translation>選択したものへの最後の変更の前の状態を表示します。押している間、またはクリックで切り替え。</translation>
    </message>
</context>
<context>
    <name>suffuse::CrossSectionPlot</name>
    <message>
        <source>Not painted yet</source>
        <translation>まだ描かれていません</translation>
    </message>
    <message>
        <source>cross-section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Covers up to %1</source>
        <translation>被覆率は最大 %1</translation>
    </message>
</context>
<context>
    <name>suffuse::CurrentLayer</name>
    <message>
        <source>Layer: %1</source>
        <translation>レイヤー：%1</translation>
    </message>
    <message>
        <source>No layer: paint goes on top of all</source>
        <translation>レイヤーなし：全体の一番上に描きます</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>レイヤー %1</translation>
    </message>
    <message>
        <source>New layer: %1. Paint on it.</source>
        <translation>新規レイヤー：%1。ここに描いてください。</translation>
    </message>
    <message>
        <source>New clipped layer: %1. Paint on it, where the layer below has paint.</source>
        <translation>新規クリッピングレイヤー：%1。下のレイヤーに絵の具がある所に描いてください。</translation>
    </message>
    <message>
        <source>All is shown again, since this would be hidden</source>
        <translation>これが隠れてしまうため、すべて再表示しました</translation>
    </message>
    <message>
        <source>%1 is locked: nothing is painted there</source>
        <translation>%1 はロックされているため、描けません</translation>
    </message>
    <message>
        <source>%1 is hidden: nothing is painted there</source>
        <translation>%1 は非表示のため、描けません</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation>%1 のコピー</translation>
    </message>
    <message>
        <source>%1 copy %2</source>
        <translation>%1 のコピー %2</translation>
    </message>
    <message>
        <source>Only what is on %1 is reached. Layer ▸ This Layer Only reaches all again.</source>
        <translation>%1 にあるものだけが対象です。「レイヤー ▸ このレイヤーのみ」をオフにすると、すべてが対象になります。</translation>
    </message>
</context>
<context>
    <name>suffuse::CurveEditor</name>
    <message>
        <source>along the stroke →</source>
        <translation>ストロークに沿って →</translation>
    </message>
</context>
<context>
    <name>suffuse::DensityPlot</name>
    <message>
        <source>Coverage at the peak density %1: %2 %</source>
        <translation>最大濃度 %1 での被覆率：%2 %</translation>
    </message>
    <message>
        <source>density φ — first of several styles</source>
        <translation>濃度 φ — 複数のスタイルのうち最初のもの</translation>
    </message>
    <message>
        <source>density φ</source>
        <translation>濃度 φ</translation>
    </message>
    <message>
        <source>F(φ), peak %1</source>
        <translation>F(φ)、最大 %1</translation>
    </message>
</context>
<context>
    <name>suffuse::Docks</name>
    <message>
        <source>&amp;Arrange</source>
        <translation>重ね順(&amp;A)</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>プローブ</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Brushes</source>
        <translation>ブラシ</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>インスペクター</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参照</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingTool</name>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>What was drawn encloses no area: nothing was added.</source>
        <translation>描いた線が面積を囲んでいないため、何も追加されませんでした。</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>塗り</translation>
    </message>
    <message>
        <source>Outline and fill</source>
        <translation>アウトラインと塗り</translation>
    </message>
    <message>
        <source>What of the shape is painted</source>
        <translation>図形のどの部分を描くか</translation>
    </message>
</context>
<context>
    <name>suffuse::Editor</name>
    <message>
        <source>Untitled</source>
        <translation>無題</translation>
    </message>
    <message>
        <source>%1 (recovered)</source>
        <extracomment>name of a document that was brought back after a crash</extracomment>
        <translation>%1（復旧済み）</translation>
    </message>
    <message>
        <source>is damaged, so the painting stays as it is; save it, or open the file to see what is whole of it</source>
        <translation>破損しているため、絵は今のままです。保存するか、ファイルを開いて無事な部分を確認してください</translation>
    </message>
    <message>
        <source>Revert</source>
        <translation>保存時の状態に戻す</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserFields</name>
    <message>
        <source>Fade</source>
        <translation>薄くする</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>吸い取る</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>カット</translation>
    </message>
    <message>
        <source>Fade makes paint paler, wherever it is seen; Lift takes its density away, so that edges draw in; Cut cuts curves out</source>
        <translation>「薄くする」は、見えている所の絵の具を薄くします。「吸い取る」は濃度を取り除くため、縁が内側へ縮みます。「カット」は曲線を切り抜きます</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>Softness</source>
        <translation>やわらかさ</translation>
    </message>
    <message>
        <source>How far what is taken away spreads, as a share of the radius</source>
        <translation>取り除く範囲の広がり（半径に対する割合）</translation>
    </message>
    <message>
        <source>Selected Strokes</source>
        <extracomment>scope of the eraser, while no stroke is selected</extracomment>
        <translation>選択したストローク</translation>
    </message>
    <message>
        <source>Current Group</source>
        <translation>現在のグループ</translation>
    </message>
    <message>
        <source>All Strokes</source>
        <translation>すべてのストローク</translation>
    </message>
    <message>
        <source>From which strokes; without a selection, the first choice means all</source>
        <translation>対象のストローク。選択がない場合、最初の項目はすべてを表します</translation>
    </message>
    <message>
        <source>All (None Selected)</source>
        <translation>すべて（選択なし）</translation>
    </message>
    <message>
        <source>Fade: the share of the paint that is taken. Lift: how much density, so that feathered paint gets paler and paint with a sharp edge narrower. A pen&apos;s pressure takes from it</source>
        <translation>薄くする：取り除く絵の具の割合。吸い取る：取り除く濃度の量。ぼかしの絵の具は薄くなり、縁のはっきりした絵の具は細くなります。筆圧が弱いほど小さくなります</translation>
    </message>
    <message>
        <source>Sharp edges draw in.</source>
        <translation>くっきりした縁は後退します。</translation>
    </message>
</context>
<context>
    <name>suffuse::ErasureRows</name>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Fade makes paint paler; Lift takes its density away, so that edges draw in.</source>
        <translation>「薄くする」は絵の具を薄くします。「吸い取る」は濃度を取り除くため、縁が内側へ縮みます。</translation>
    </message>
    <message>
        <source>Fade</source>
        <translation>薄くする</translation>
    </message>
    <message>
        <source>Lift</source>
        <translation>吸い取る</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>The diameter of the eraser, if its softness was the usual one.</source>
        <translation>消しゴムの直径（やわらかさが標準の場合）。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>The share of the paint that it takes in its middle.</source>
        <translation>中央で取り除く絵の具の割合。</translation>
    </message>
    <message>
        <source>Density taken</source>
        <translation>取り除く密度</translation>
    </message>
    <message>
        <source>Change size</source>
        <translation>サイズを変更</translation>
    </message>
    <message>
        <source>The density that it takes away in its middle: paint that is thinner is gone there.</source>
        <translation>中央で取り除く密度。それより薄い絵具はそこでなくなります。</translation>
    </message>
    <message>
        <source>Change strength</source>
        <translation>強さを変更</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>選択したものすべてには設定できません。範囲外になる値があります。</translation>
    </message>
    <message>
        <source>Change kind of erasure</source>
        <translation>消し跡の種類を変更</translation>
    </message>
</context>
<context>
    <name>suffuse::EraserTool</name>
    <message>
        <source>Erase</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>Fade: drag to make the selected strokes paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>薄くする：ドラッグで、選択したストロークを強さに応じて薄くします。Shift：カット。[ ] でサイズ、{ } で強さ。</translation>
    </message>
    <message>
        <source>Fade: drag to make the strokes of the group paler, by the strength. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>薄くする：ドラッグで、グループのストロークを強さに応じて薄くします。Shift：カット。[ ] でサイズ、{ } で強さ。</translation>
    </message>
    <message>
        <source>Fade: drag to make paint paler, by the strength, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>薄くする：ドラッグで、見えている絵の具を強さに応じて薄くします。Shift：カット。[ ] でサイズ、{ } で強さ。</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the selected strokes. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>吸い取る：ドラッグで、選択したストロークの絵の具をやわらかく取り除きます。Shift：カット。[ ] でサイズ、{ } で強さ。</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly from the strokes of the group. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>吸い取る：ドラッグで、グループのストロークの絵の具をやわらかく取り除きます。Shift：カット。[ ] でサイズ、{ } で強さ。</translation>
    </message>
    <message>
        <source>Lift: drag to take paint away softly, wherever it is seen. Shift: cut. [ and ] change the size, { and } the strength.</source>
        <translation>吸い取る：ドラッグで、見えている絵の具をやわらかく取り除きます。Shift：カット。[ ] でサイズ、{ } で強さ。</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the selected curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>カット：ドラッグで、選択した曲線の円の下の部分を切り抜きます。Shift：やわらかく消す。[ と ] でサイズを変更。</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the group&apos;s curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>カット：ドラッグで、グループの曲線の円の下の部分を切り抜きます。Shift：やわらかく消す。[ と ] でサイズを変更。</translation>
    </message>
    <message>
        <source>Cut: drag to cut out what of the curves lies under the circle. Shift: erase softly. [ and ] change the size.</source>
        <translation>カット：ドラッグで、曲線の円の下の部分を切り抜きます。Shift：やわらかく消す。[ と ] でサイズを変更。</translation>
    </message>
    <message>
        <source>Nothing is erased: no paint is seen under the circle.</source>
        <translation>何も消えませんでした。円の下に絵の具が見えません。</translation>
    </message>
    <message>
        <source>Nothing is cut: no curve lies under the circle. Fade takes paint away wherever it is seen.</source>
        <translation>何もカットされませんでした。円の下に曲線がありません。「薄くする」なら、見えている所の絵の具を取り除けます。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not selected.</source>
        <translation>何も消えませんでした。円の下のものは選択されていません。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is in another group.</source>
        <translation>何も消えませんでした。円の下のものは別のグループにあります。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is locked.</source>
        <translation>何も消えませんでした。円の下のものはロックされています。</translation>
    </message>
    <message>
        <source>It was cut, but hardly a gap is seen: its edges are softer than the cut is wide. Fade takes its paint away.</source>
        <translation>カットされましたが、切れ目はほとんど見えません。カットの幅より縁がやわらかいためです。「薄くする」なら絵の具を取り除けます。</translation>
    </message>
    <message>
        <source>Nothing is erased: what lies under the circle is not on the layer, and only that is reached.</source>
        <translation>何も消えませんでした。円の下のものは、対象のレイヤーにありません。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportDialog</name>
    <message>
        <source>8 bit</source>
        <translation>8 ビット</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 ビット</translation>
    </message>
    <message>
        <source>16 bit floating point</source>
        <translation>16 ビット浮動小数点</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 ビット浮動小数点</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>The ending chooses the format: png, tiff, exr, jpg, webp or pfm, or ora or psd with layers.</source>
        <translation>形式は拡張子で決まります：png、tiff、exr、jpg、webp、pfm、またはレイヤー付きの ora、psd。</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>フォルダーと名前を選択</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>色深度</translation>
    </message>
    <message>
        <source>Precision of each colour channel</source>
        <translation>各カラーチャンネルの精度</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>画質</translation>
    </message>
    <message>
        <source>Of JPEG and WebP; 100 is the best. WebP loses nothing then.</source>
        <translation>JPEG と WebP の画質。100 が最高で、WebP は無劣化になります。</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>背景を透明にする</translation>
    </message>
    <message>
        <source>Leaves the background out and stores how much the paint covers.</source>
        <translation>背景を省き、絵の具の被覆率を記録します。</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Width in pixels</source>
        <translation>幅（ピクセル）</translation>
    </message>
    <message>
        <source>Width in pixels; the height follows.</source>
        <translation>幅（ピクセル）。高さは自動で決まります。</translation>
    </message>
    <message>
        <source>Height in pixels</source>
        <translation>高さ（ピクセル）</translation>
    </message>
    <message>
        <source>Height in pixels; the width follows.</source>
        <translation>高さ（ピクセル）。幅は自動で決まります。</translation>
    </message>
    <message>
        <source>painting</source>
        <translation>絵</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>“%1” has no ending of a picture format. Choose one of: %2.</source>
        <translation>「%1」に画像形式の拡張子がありません。次のいずれかを選んでください：%2。</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 はすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>エクスポート(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>参照(&amp;B)…</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>今の内容は失われます。</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>置き換え(&amp;R)</translation>
    </message>
    <message>
        <source>At most %1 × %2 px</source>
        <translation>最大 %1 × %2 px</translation>
    </message>
    <message>
        <source>Export Picture</source>
        <translation>画像をエクスポート</translation>
    </message>
    <message>
        <source>No picture format</source>
        <translation>画像形式ではありません</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>What is written. The ending of the file&apos;s name says the same.</source>
        <translation>書き込む形式。ファイル名の拡張子と同じです。</translation>
    </message>
    <message>
        <source>Pictures are written here. File ▸ Export Drawing writes SVG.</source>
        <translation>ここでは画像を書き込みます。SVG は「ファイル ▸ ベクター画像をエクスポート」で書き込みます。</translation>
    </message>
    <message>
        <source>Photoshop (layers)</source>
        <translation>Photoshop（レイヤー）</translation>
    </message>
    <message>
        <source>OpenRaster (layers)</source>
        <translation>OpenRaster（レイヤー）</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>カラー</translation>
    </message>
    <message>
        <source>The colour profile that the file has. The painting keeps the one that was chosen from a file.</source>
        <translation>ファイルのカラープロファイル。ファイルから選んだものは絵に保存されます。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExportJob</name>
    <message>
        <source>A picture of %1 × %2 pixels does not fit into memory. Choose a smaller size.</source>
        <translation>%1 × %2 ピクセルの画像はメモリに収まりません。より小さいサイズを選んでください。</translation>
    </message>
</context>
<context>
    <name>suffuse::Exporting</name>
    <message>
        <source>Exported to %1</source>
        <translation>%1 にエクスポートしました</translation>
    </message>
    <message>
        <source>Printed to %1</source>
        <translation>%1 に印刷しました</translation>
    </message>
    <message>
        <source>Given to the printer %1</source>
        <translation>プリンター %1 に送りました</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 をエクスポート中…</translation>
    </message>
</context>
<context>
    <name>suffuse::EyedropperTool</name>
    <message>
        <source>Click to take the picture&apos;s colour as the current one. Shift: the stroke&apos;s own colour.</source>
        <translation>クリックで表示色を現在の色にします。Shift：ストローク自体の色。</translation>
    </message>
    <message>
        <source>A click takes</source>
        <translation>クリックで採取</translation>
    </message>
    <message>
        <source>The colour, to paint with</source>
        <translation>描画色</translation>
    </message>
    <message>
        <source>The appearance, for the selection</source>
        <translation>外観</translation>
    </message>
    <message>
        <source>Match</source>
        <translation>外観を合わせる</translation>
    </message>
    <message>
        <source>Select strokes first: they get the appearance of the stroke you click.</source>
        <translation>先にストロークを選択してください。クリックしたストロークの外観が付きます。</translation>
    </message>
    <message>
        <source>Click a stroke: the selected ones get its appearance, and what varies along them stays. Shift: the same values all along.</source>
        <translation>ストロークをクリックすると、選択したものに外観が付き、ストロークに沿った変化は残ります。Shift：全体を同じ値に。</translation>
    </message>
    <message>
        <source>Click to give what is selected the picture&apos;s colour. Shift: the stroke&apos;s own colour. Ctrl: its whole appearance.</source>
        <translation>クリックで、選択したものに表示色を付けます。Shift：ストローク自体の色。Ctrl：外観全体。</translation>
    </message>
    <message>
        <source>Click to give the swatch the picture&apos;s colour. Shift: the stroke&apos;s own colour.</source>
        <translation>クリックで、スウォッチを表示色にします。Shift：ストローク自体の色。</translation>
    </message>
    <message>
        <source>A colour, or style, values and colour of a stroke for the selected ones. The colour is for what the Colour dock shows: the brush, the selection or a swatch.</source>
        <translation>色、または選択したものに付けるストロークのスタイル・値・色。色は、色ドックに表示中のもの（ブラシ、選択範囲、スウォッチ）に付きます。</translation>
    </message>
    <message>
        <source>The colour, for the selection</source>
        <translation>色（選択範囲用）</translation>
    </message>
    <message>
        <source>The colour, for the swatch</source>
        <translation>色（スウォッチ用）</translation>
    </message>
</context>
<context>
    <name>suffuse::FiguresSection</name>
    <message>
        <source>The outline lays no paint: its density φ is 0. What is seen is the fill.</source>
        <translation>アウトラインの濃度 φ が 0 のため、絵の具が置かれません。見えているのは塗りです。</translation>
    </message>
    <message>
        <source>Density function</source>
        <translation>濃度関数</translation>
    </message>
    <message>
        <source>How density becomes coverage. The mark is the peak density of the selected segments.</source>
        <translation>濃度から被覆率への変わり方。印は、選択したセグメントの最大濃度です。</translation>
    </message>
    <message>
        <source>Cross-section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>The cut through the stroke at the first selected segment, at the moment shown: coverage, on the colour that it has on the background.</source>
        <translation>選択した最初のセグメントでの、表示中の時点のストロークの断面。背景に重ねた色での被覆率です。</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>警告</translation>
    </message>
    <message>
        <source>Spread s</source>
        <translation>広がり s</translation>
    </message>
    <message>
        <source>Peak density</source>
        <translation>最大濃度</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>半幅</translation>
    </message>
    <message>
        <source>Fades away</source>
        <translation>消える時</translation>
    </message>
    <message>
        <source>Density in the middle of a long straight stroke, dry.</source>
        <translation>長くまっすぐなストロークが乾いたときの、中央の濃度。</translation>
    </message>
    <message>
        <source>From the middle to the visible edge of a long straight stroke, dry.</source>
        <translation>長くまっすぐなストロークが乾いたときの、中央から見える縁までの幅。</translation>
    </message>
    <message>
        <source>When the paint has spread so thin that nothing of it is visible any more.</source>
        <translation>絵の具が薄く広がり、まったく見えなくなる時。</translation>
    </message>
    <message>
        <source>never</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>partly, from %1</source>
        <translation>一部、%1 から</translation>
    </message>
    <message>
        <source>after %1</source>
        <translation>%1 後</translation>
    </message>
    <message>
        <source>Spread along</source>
        <translation>線方向の広がり</translation>
    </message>
    <message>
        <source>How far the paint has spread across the curve once it is dry: √(4·D·t_max).</source>
        <translation>乾いたときに、絵の具が曲線を横切る方向へ広がる距離：√(4·D·t_max)。</translation>
    </message>
    <message>
        <source>How far it has spread along the curve.</source>
        <translation>曲線に沿った方向へ広がる距離。</translation>
    </message>
    <message>
        <source>Spread across</source>
        <translation>幅方向の広がり</translation>
    </message>
    <message>
        <source>Takes away</source>
        <translation>取り除く量</translation>
    </message>
    <message>
        <source>How softly the erasure ends: how far it has spread beside its curve, √(4·D·t_max).</source>
        <translation>消し跡の縁のやわらかさ。曲線の横へ広がった距離：√(4·D·t_max)。</translation>
    </message>
    <message>
        <source>What one segment of the erasure takes away in its middle: the share of the paint if it fades; density if it lifts, and paint that is thinner is gone there.</source>
        <translation>消し跡の 1 セグメントが中央で取り除く量。「薄くする」では絵の具の割合、「吸い取る」では濃度で、これより薄い絵の具はなくなります。</translation>
    </message>
</context>
<context>
    <name>suffuse::FileOpening</name>
    <message>
        <source>Pictures with layers (*.ora *.psd)</source>
        <translation>レイヤー付き画像 (*.ora *.psd)</translation>
    </message>
    <message>
        <source>All that can be opened (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</source>
        <translation>開けるすべてのファイル (*.suffuse *.json *.ora *.psd *.csv *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote *.svg *.svgz *.pdf *.xml)</translation>
    </message>
    <message>
        <source>Suffuse paintings (*.suffuse *.json)</source>
        <translation>Suffuse の絵 (*.suffuse *.json)</translation>
    </message>
    <message>
        <source>Backups of paintings (*.suffuse~* *.json~*)</source>
        <translation>絵のバックアップ (*.suffuse~* *.json~*)</translation>
    </message>
    <message>
        <source>Pen recordings (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</source>
        <translation>ペンの記録 (*.csv *.json *.excalidraw *.dat *.xopp *.xoj *.uim *.inkml *.rnote)</translation>
    </message>
    <message>
        <source>Drawings (*.svg *.svgz *.pdf)</source>
        <translation>ベクター画像 (*.svg *.svgz *.pdf)</translation>
    </message>
    <message>
        <source>Diffusion curves (*.xml)</source>
        <translation>拡散曲線 (*.xml)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>開く</translation>
    </message>
    <message>
        <source>“%1” is open already.</source>
        <translation>「%1」はすでに開いています。</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was opened; the file itself is left as it is.</source>
        <translation>「%1」は破損しています。無事な部分を開きました。ファイル自体は元のままです。</translation>
    </message>
    <message>
        <source>&amp;Clear the List</source>
        <translation>一覧を消去(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::FileRestoring</name>
    <message>
        <source>Revert “%1” to what the file holds?</source>
        <translation>「%1」をファイルの内容に戻しますか？</translation>
    </message>
    <message>
        <source>What was painted since the last save goes; Undo brings it back.</source>
        <translation>前回の保存以降に描いたものがなくなります。「元に戻す」で戻せます。</translation>
    </message>
    <message>
        <source>&amp;Revert</source>
        <translation>戻す(&amp;R)</translation>
    </message>
    <message>
        <source>Restore backup of %1</source>
        <translation>%1 のバックアップから復元</translation>
    </message>
    <message>
        <source>The backup of %1 is back. Undo takes it away again; no file changes until you save.</source>
        <translation>%1 のバックアップに戻りました。「元に戻す」で取り消せます。保存するまでファイルは変わりません。</translation>
    </message>
    <message>
        <source>The backup of %1 is what you see: nothing has changed.</source>
        <translation>%1 のバックアップは今の絵と同じです。何も変わっていません。</translation>
    </message>
    <message>
        <source>The backup is damaged. What is whole of it was restored.</source>
        <translation>バックアップが破損しています。無事な部分を復元しました。</translation>
    </message>
</context>
<context>
    <name>suffuse::FileSaving</name>
    <message>
        <source>What you paint now would not survive a crash: %1. Painting goes on; save from time to time.</source>
        <translation>これから描くものは、異常終了すると失われます：%1。このまま描けますが、ときどき保存してください。</translation>
    </message>
    <message>
        <source>“%1” is gone from its folder. Save to put it back.</source>
        <translation>「%1」がフォルダーからなくなっています。保存すると元に戻ります。</translation>
    </message>
    <message>
        <source>Save As</source>
        <translation>名前を付けて保存</translation>
    </message>
    <message>
        <source>%1 copy</source>
        <extracomment>name of the file that a copy is saved to, beside that of the painting</extracomment>
        <translation>%1 のコピー</translation>
    </message>
    <message>
        <source>Save a Copy</source>
        <translation>コピーを保存</translation>
    </message>
    <message>
        <source>Saving “%1”…</source>
        <translation>「%1」を保存中…</translation>
    </message>
    <message>
        <source>A copy is saved as “%1”.</source>
        <translation>コピーを「%1」として保存しました。</translation>
    </message>
    <message>
        <source>“%1” is saved already.</source>
        <translation>「%1」は保存済みです。</translation>
    </message>
    <message>
        <source>%1 (without what is still being drawn)</source>
        <translation>%1（描いている途中のものを除く）</translation>
    </message>
    <message>
        <source>Saved “%1”, %2</source>
        <translation>「%1」を保存しました（%2）</translation>
    </message>
    <message>
        <source>Saved “%1”, but %2</source>
        <translation>「%1」を保存しましたが、%2</translation>
    </message>
    <message>
        <source>“%1” is not saved.</source>
        <translation>「%1」は保存されていません。</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse の絵</translation>
    </message>
    <message>
        <source>Text form</source>
        <translation>テキスト形式</translation>
    </message>
    <message>
        <source>“%1” is open in another window. Choose another name, or close that window first.</source>
        <translation>「%1」は別のウィンドウで開いています。別の名前を選ぶか、先にそのウィンドウを閉じてください。</translation>
    </message>
    <message>
        <source>“%1” has plain lines and areas, for other programs. Export Drawing keeps soft and dark edges.</source>
        <translation>「%1」は、ほかのプログラム用の単純な線と面です。「ベクター画像をエクスポート」なら、やわらかい縁や濃い縁が残ります。</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG ベクター画像</translation>
    </message>
</context>
<context>
    <name>suffuse::FileTypes</name>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse の絵</translation>
    </message>
    <message>
        <source>Suffuse brush</source>
        <translation>Suffuse ブラシ</translation>
    </message>
    <message>
        <source>Backup of a painting</source>
        <translation>絵のバックアップ</translation>
    </message>
</context>
<context>
    <name>suffuse::Files</name>
    <message numerus="yes">
        <source>%n adjustment or fill layer(s)</source>
        <translation>
            <numerusform>調整レイヤーまたは塗りつぶしレイヤー %n 枚</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the effects of %n layer(s)</source>
        <translation>
            <numerusform>%n 枚のレイヤーの効果</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mask(s) of %n group(s)</source>
        <translation>
            <numerusform>%n 個のグループのマスク</numerusform>
        </translation>
    </message>
    <message>
        <source>This Photoshop file is damaged.</source>
        <translation>この Photoshop ファイルは破損しています。</translation>
    </message>
    <message>
        <source>Photoshop picture</source>
        <translation>Photoshop 画像</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Photoshop files over 30,000 pixels a side (PSB) are not read. Save it as PSD.</source>
        <translation>一辺が 30,000 ピクセルを超える Photoshop ファイル（PSB）は読み込めません。PSD で保存してください。</translation>
    </message>
    <message>
        <source>Only Photoshop files in RGB or grey of 8 or 16 bits are read. Convert it to RGB.</source>
        <translation>読み込めるのは、8 または 16 ビットの RGB かグレースケールの Photoshop ファイルだけです。RGB に変換してください。</translation>
    </message>
    <message numerus="yes">
        <source>%n layer(s) whose picture is missing, damaged or too large</source>
        <translation>
            <numerusform>画像がないか、破損しているか、大きすぎるレイヤー %n 枚</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the mode(s) of %n layer(s)</source>
        <translation>
            <numerusform>%n 枚のレイヤーの合成モード</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: %1.</source>
        <translation>この OpenRaster ファイルは破損しています: %1。</translation>
    </message>
    <message>
        <source>it has no list of its layers</source>
        <translation>レイヤーの一覧がありません</translation>
    </message>
    <message>
        <source>its list of layers cannot be read</source>
        <translation>レイヤーの一覧を読み込めません</translation>
    </message>
    <message>
        <source>is a folder; give a file name inside it</source>
        <translation>フォルダーです。その中のファイル名を指定してください</translation>
    </message>
    <message>
        <source>is a device or a pipe, not a file; save to a file</source>
        <translation>ファイルではなく、デバイスかパイプです。ファイルに保存してください</translation>
    </message>
    <message>
        <source>the folder %1 does not exist; create it or choose another one</source>
        <translation>フォルダー %1 はありません。作成するか、別のフォルダーを選んでください</translation>
    </message>
    <message>
        <source>%1 is not a folder; choose another place</source>
        <translation>%1 はフォルダーではありません。別の場所を選んでください</translation>
    </message>
    <message>
        <source>the folder %1 is read-only; choose another one or change its permissions</source>
        <translation>フォルダー %1 は読み取り専用です。別のフォルダーを選ぶか、アクセス権を変更してください</translation>
    </message>
    <message>
        <source>The file has no name; choose one</source>
        <translation>ファイルに名前がありません。名前を選んでください</translation>
    </message>
    <message>
        <source>would have more than 2 GB; nothing was written</source>
        <translation>2 GB を超えてしまいます。何も書き込まれていません</translation>
    </message>
    <message>
        <source>cannot be written (%1); choose another place</source>
        <translation>書き込めません（%1）。別の場所を選んでください</translation>
    </message>
    <message>
        <source>%1 (%2); the old file, if there was one, is as before. Free some space or choose another place</source>
        <translation>%1（%2）。元のファイルがあれば、そのまま残っています。空きを作るか、別の場所を選んでください</translation>
    </message>
    <message>
        <source>could not be written in full</source>
        <translation>最後まで書き込めませんでした</translation>
    </message>
    <message>
        <source>could not be put in place</source>
        <translation>所定の場所に置けませんでした</translation>
    </message>
    <message>
        <source>was written, but the folder could not be brought to the disk (%1); save once more before you switch off</source>
        <translation>書き込みましたが、フォルダーをディスクに反映できませんでした（%1）。電源を切る前にもう一度保存してください</translation>
    </message>
    <message>
        <source>the image has %1 MB; at most 64 MB are possible, make it smaller</source>
        <translation>画像が %1 MB あります。上限は 64 MB です。小さくしてください</translation>
    </message>
    <message>
        <source>is not a PNG, JPEG, TIFF, WebP or EXR image; convert it to one of them</source>
        <translation>PNG、JPEG、TIFF、WebP、EXR の画像ではありません。いずれかに変換してください</translation>
    </message>
    <message>
        <source>is empty; give a data: URL or the path of an image file</source>
        <translation>空です。data: URL か画像ファイルのパスを指定してください</translation>
    </message>
    <message>
        <source>the image file %1 is missing; put it there or correct the path</source>
        <translation>画像ファイル %1 がありません。そこに置くか、パスを修正してください</translation>
    </message>
    <message>
        <source>%1 is not a file</source>
        <translation>%1 はファイルではありません</translation>
    </message>
    <message>
        <source>the image file %1 has %2 MB; at most 64 MB are possible</source>
        <translation>画像ファイル %1 は %2 MB あります。上限は 64 MB です</translation>
    </message>
    <message>
        <source>the image file %1 cannot be read: %2</source>
        <translation>画像ファイル %1 を読み込めません: %2</translation>
    </message>
    <message>
        <source>is not a data:…;base64,… URL</source>
        <translation>data:…;base64,… の URL ではありません</translation>
    </message>
    <message>
        <source>the image is too large; at most 64 MB are possible</source>
        <translation>画像が大きすぎます。上限は 64 MB です</translation>
    </message>
    <message>
        <source>the base64 data of the image are damaged</source>
        <translation>画像の base64 データが破損しています</translation>
    </message>
    <message>
        <source>has more than 2 GB; that is more than can be opened</source>
        <translation>2 GB を超えています。これより大きいファイルは開けません</translation>
    </message>
    <message>
        <source>could not be read: %1</source>
        <translation>読み込めませんでした: %1</translation>
    </message>
    <message>
        <source>Suffuse painting</source>
        <translation>Suffuse の絵</translation>
    </message>
    <message>
        <source>Suffuse text form</source>
        <translation>Suffuse テキスト形式</translation>
    </message>
    <message>
        <source>Ink recording (CSV)</source>
        <translation>インク記録 (CSV)</translation>
    </message>
    <message>
        <source>Universal Ink</source>
        <translation>Universal Ink</translation>
    </message>
    <message>
        <source>Excalidraw drawing</source>
        <translation>Excalidraw ベクター画像</translation>
    </message>
    <message>
        <source>MyPaint events</source>
        <translation>MyPaint イベント</translation>
    </message>
    <message>
        <source>Unknown format</source>
        <translation>不明な形式</translation>
    </message>
    <message>
        <source>there is no such file: %1</source>
        <translation>そのようなファイルはありません: %1</translation>
    </message>
    <message>
        <source>is a folder; give a file inside it</source>
        <translation>フォルダーです。その中のファイルを指定してください</translation>
    </message>
    <message>
        <source>could not be opened: %1; check its permissions</source>
        <translation>開けませんでした: %1。アクセス権を確認してください</translation>
    </message>
    <message>
        <source>the ending is neither .suffuse nor .json; choose one of them</source>
        <translation>拡張子が .suffuse でも .json でもありません。どちらかを選んでください</translation>
    </message>
    <message>
        <source>%1: has less than 2 numbers</source>
        <translation>%1: 数値が 2 個未満です</translation>
    </message>
    <message>
        <source>holds no freedraw elements; only those become strokes</source>
        <translation>freedraw 要素がありません。ストロークになるのはこの要素だけです</translation>
    </message>
    <message>
        <source>is not a JSON object</source>
        <translation>JSON オブジェクトではありません</translation>
    </message>
    <message>
        <source>: is not a list of numbers</source>
        <translation>: 数値のリストではありません</translation>
    </message>
    <message>
        <source>%1[%2]: is not a number within ±1e15</source>
        <translation>%1[%2]: ±1e15 の範囲の数値ではありません</translation>
    </message>
    <message>
        <source>line %1, column %2: “%3” is not a number within ±1e15</source>
        <translation>%1 行目、%2 列目: 「%3」は ±1e15 の範囲の数値ではありません</translation>
    </message>
    <message>
        <source>is empty; there is nothing to paint</source>
        <translation>空です。描くものがありません</translation>
    </message>
    <message>
        <source>line %1: no columns x and y; name the columns x, y, time and pressure</source>
        <translation>%1 行目: 列 x と y がありません。列の名前を x、y、time、pressure にしてください</translation>
    </message>
    <message>
        <source>%1: splineX has %2 numbers, splineY %3</source>
        <translation>%1: splineX の数値は %2 個、splineY は %3 個です</translation>
    </message>
    <message>
        <source>an object {…}</source>
        <translation>オブジェクト {…}</translation>
    </message>
    <message>
        <source>a list […]</source>
        <translation>リスト […]</translation>
    </message>
    <message>
        <source>the file ends here, “%1” is missing; it is probably cut off</source>
        <translation>ファイルがここで終わっており、「%1」がありません。途中で切れている可能性があります</translation>
    </message>
    <message>
        <source>expected “,” or “%1” before “%2”</source>
        <translation>「%2」の前に「,」か「%1」が必要です</translation>
    </message>
    <message>
        <source>expected a member&apos;s name in quotes before “%1”</source>
        <translation>「%1」の前に、引用符で囲んだメンバー名が必要です</translation>
    </message>
    <message>
        <source>expected “:” after “%1”</source>
        <translation>「%1」の後に「:」が必要です</translation>
    </message>
    <message>
        <source>is given twice; keep one of them</source>
        <translation>2 回指定されています。1 つだけ残してください</translation>
    </message>
    <message>
        <source>is not a member of this format; correct or remove it</source>
        <translation>この形式のメンバーではありません。修正するか削除してください</translation>
    </message>
    <message>
        <source>a string has a wrong escape “\%1”</source>
        <translation>文字列に誤ったエスケープ「\%1」があります</translation>
    </message>
    <message>
        <source>the file ends inside a string; it is probably cut off</source>
        <translation>ファイルが文字列の途中で終わっています。途中で切れている可能性があります</translation>
    </message>
    <message>
        <source>a string has a control character; write it as an escape such as \n</source>
        <translation>文字列に制御文字があります。\n のようなエスケープで書いてください</translation>
    </message>
    <message>
        <source>the file ends here; it is probably cut off</source>
        <translation>ファイルがここで終わっています。途中で切れている可能性があります</translation>
    </message>
    <message>
        <source>expected %1 before “%2”</source>
        <translation>「%2」の前に%1が必要です</translation>
    </message>
    <message>
        <source>%1 is not %2</source>
        <translation>%1 は%2ではありません</translation>
    </message>
    <message>
        <source>has %1 numbers instead of %2</source>
        <translation>数値が %2 個ではなく %1 個あります</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>%1 is too large; the largest number is %2</source>
        <translation>%1 は大きすぎます。最大の数値は %2 です</translation>
    </message>
    <message>
        <source>%1 is not a whole number from 0 to 2^64 − 1</source>
        <translation>%1 は 0～2^64 − 1 の整数ではありません</translation>
    </message>
    <message>
        <source>%1 s is not in [-1e12, 1e12]</source>
        <translation>%1 s は [-1e12, 1e12] の範囲外です</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true または false</translation>
    </message>
    <message>
        <source>a string in quotes</source>
        <translation>引用符で囲んだ文字列</translation>
    </message>
    <message>
        <source>is not UTF-8; save the file in that encoding</source>
        <translation>UTF-8 ではありません。UTF-8 でファイルを保存してください</translation>
    </message>
    <message>
        <source>“%1” follows after the end of the painting; remove it</source>
        <translation>絵の終わりの後に「%1」があります。削除してください</translation>
    </message>
    <message>
        <source>line %1, column %2: %3</source>
        <translation>%1 行目、%2 列目: %3</translation>
    </message>
    <message>
        <source>standard input</source>
        <translation>標準入力</translation>
    </message>
    <message>
        <source>holds no pen strokes; there is nothing to paint</source>
        <translation>ペンのストロークがありません。描くものがありません</translation>
    </message>
    <message>
        <source>the strokes span %1 × %2 units; at most 1e6 are possible, scale them down</source>
        <translation>ストロークの範囲が %1 × %2 単位あります。上限は 1e6 です。縮小してください</translation>
    </message>
    <message>
        <source>line %1, column %2</source>
        <translation>%1 行目、%2 列目</translation>
    </message>
    <message>
        <source>a value has the wrong type</source>
        <translation>値の型が正しくありません</translation>
    </message>
    <message>
        <source>the first chunk must be HEAD</source>
        <translation>最初のチャンクは HEAD でなければなりません</translation>
    </message>
    <message>
        <source>there is more than one HEAD</source>
        <translation>HEAD が複数あります</translation>
    </message>
    <message>
        <source>there is more than one</source>
        <translation>複数あります</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2 is unknown, and the painting needs it; update Suffuse</source>
        <translation>チャンク %1（バイト %2）は不明ですが、この絵に必要です。Suffuse を更新してください</translation>
    </message>
    <message>
        <source>is not a CBOR map</source>
        <translation>CBOR のマップではありません</translation>
    </message>
    <message>
        <source>lacks the version or the counts</source>
        <translation>バージョンか個数がありません</translation>
    </message>
    <message>
        <source>was written by a newer program (%1): it needs a reader of version %2, this one is %3; update Suffuse</source>
        <translation>より新しいプログラム（%1）で書き込まれています。読み込みにはバージョン %2 への対応が必要ですが、これが対応するのは %3 までです。Suffuse を更新してください</translation>
    </message>
    <message>
        <source>the chunk DOCU is missing; the file is damaged, take a backup copy</source>
        <translation>チャンク DOCU がありません。ファイルが破損しています。バックアップを使ってください</translation>
    </message>
    <message>
        <source>should hold %1 strokes and %2 segments, but holds %3 and %4; the file is damaged, take a backup copy</source>
        <translation>ストローク %1 本とセグメント %2 個のはずが、%3 本と %4 個です。ファイルが破損しています。バックアップを使ってください</translation>
    </message>
    <message>
        <source>the file is damaged, take a backup copy</source>
        <translation>ファイルが破損しています。バックアップを使ってください</translation>
    </message>
    <message>
        <source>is not a .suffuse file</source>
        <translation>.suffuse ファイルではありません</translation>
    </message>
    <message>
        <source>the hash of the whole differs</source>
        <translation>全体のハッシュが一致しません</translation>
    </message>
    <message>
        <source>%1 bytes follow after the end</source>
        <translation>終わりの後に %1 バイトあります</translation>
    </message>
    <message>
        <source>has %1 bytes, but the file only %2 more</source>
        <translation>%1 バイトのはずですが、ファイルにはあと %2 バイトしかありません</translation>
    </message>
    <message>
        <source>checksum differs</source>
        <translation>チェックサムが一致しません</translation>
    </message>
    <message>
        <source>%1 strokes and %2 segments are more than the file can hold</source>
        <translation>ストローク %1 本とセグメント %2 個は、このファイルに収まる数を超えています</translation>
    </message>
    <message>
        <source>its columns are not what the format allows</source>
        <translation>列が形式に合っていません</translation>
    </message>
    <message>
        <source>stroke %1 of it is not what the format allows</source>
        <translation>ストローク %1 が形式に合っていません</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>“%1” is none of: %2</source>
        <translation>「%1」は次のいずれでもありません: %2</translation>
    </message>
    <message>
        <source>has %1 numbers; the kind %2 has %3</source>
        <translation>数値が %1 個ありますが、種類 %2 は %3 個です</translation>
    </message>
    <message>
        <source>belongs to the mode beta; remove it or change the mode</source>
        <translation>モード beta のものです。削除するか、モードを変更してください</translation>
    </message>
    <message>
        <source>has %1 points instead of 4</source>
        <translation>点が 4 個ではなく %1 個あります</translation>
    </message>
    <message>
        <source>has %1 numbers instead of 2</source>
        <translation>数値が 2 個ではなく %1 個あります</translation>
    </message>
    <message>
        <source>0 is not an id; count from 1 or leave it out</source>
        <translation>0 は ID になりません。1 から数えるか、省いてください</translation>
    </message>
    <message>
        <source>%1 is not in [0, 4294967295]</source>
        <translation>%1 は [0, 4294967295] の範囲外です</translation>
    </message>
    <message>
        <source>width and height must not be negative</source>
        <translation>幅と高さは負にできません</translation>
    </message>
    <message>
        <source>%1 is not in [0, 1]</source>
        <translation>%1 は [0, 1] の範囲外です</translation>
    </message>
    <message>
        <source>“%1” is not “suffuse-text”</source>
        <translation>「%1」は「suffuse-text」ではありません</translation>
    </message>
    <message>
        <source>0 is not a version; write 1</source>
        <translation>0 はバージョンになりません。1 と書いてください</translation>
    </message>
    <message>
        <source>%1 is not a version that this program reads; it reads 1</source>
        <translation>%1 は、このプログラムが読み込めるバージョンではありません。読み込めるのは 1 です</translation>
    </message>
    <message>
        <source>another curve is of the same quantity and input; keep one of them</source>
        <translation>同じ量と入力の曲線がほかにあります。1 つだけ残してください</translation>
    </message>
    <message>
        <source>needs 2 to 16 points [x, y] in [0, 1], from left to right</source>
        <translation>[0, 1] の範囲の点 [x, y] が、左から右へ 2～16 個必要です</translation>
    </message>
    <message>
        <source>could not be opened: %1</source>
        <translation>開けませんでした: %1</translation>
    </message>
    <message>
        <source>has more than 1 MB; it is not a brush</source>
        <translation>1 MB を超えています。ブラシではありません</translation>
    </message>
    <message>
        <source>a colour has three numbers: red, green, blue</source>
        <translation>色には赤、緑、青の 3 つの数値があります</translation>
    </message>
    <message>
        <source>“%1” is not a number from 0 to 255</source>
        <translation>「%1」は 0～255 の数値ではありません</translation>
    </message>
    <message>
        <source>is larger than 1 MiB; a palette is not</source>
        <translation>1 MiB を超えています。パレットではありません</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>%1 行目: %2</translation>
    </message>
    <message>
        <source>“GIMP Palette” is missing: this is no GIMP palette</source>
        <translation>「GIMP Palette」がありません。GIMP パレットではありません</translation>
    </message>
    <message>
        <source>there are more than %1 colours</source>
        <translation>色が %1 個を超えています</translation>
    </message>
    <message>
        <source>has no settings; it is not a brush</source>
        <translation>設定がありません。ブラシではありません</translation>
    </message>
    <message>
        <source>is write-protected; save under another name or change its permissions</source>
        <translation>書き込み禁止です。別の名前で保存するか、アクセス権を変更してください</translation>
    </message>
    <message>
        <source>belongs to %1, and would not any more; save under another name</source>
        <translation>所有者は %1 ですが、保存すると所有者が変わってしまいます。別の名前で保存してください</translation>
    </message>
    <message>
        <source>could not be brought to the disk</source>
        <translation>ディスクに反映できませんでした</translation>
    </message>
    <message>
        <source>the backup could not be made; check the folder</source>
        <translation>バックアップを作成できませんでした。フォルダーを確認してください</translation>
    </message>
    <message>
        <source>the first element is not curve_set</source>
        <translation>最初の要素が curve_set ではありません</translation>
    </message>
    <message>
        <source>%1 of %2 is &quot;%3&quot;, not a number up to 1e6</source>
        <translation>%2 の %1 が &quot;%3&quot; で、1e6 以下の数値ではありません</translation>
    </message>
    <message>
        <source>a curve has %1 control points; 3n + 1 make cubics</source>
        <translation>曲線の制御点が %1 個あります。三次曲線には 3n + 1 個が必要です</translation>
    </message>
    <message>
        <source>a curve has no colours on one of its sides</source>
        <translation>曲線の片側に色がありません</translation>
    </message>
    <message>
        <source>has more than 64 MB of XML; that is more than is read</source>
        <translation>XML が 64 MB を超えています。これより大きいものは読み込めません</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to paint</source>
        <translation>曲線がありません。描くものがありません</translation>
    </message>
    <message>
        <source>Diffusion curves (XML)</source>
        <translation>拡散曲線 (XML)</translation>
    </message>
    <message>
        <source>it is damaged</source>
        <translation>破損しています</translation>
    </message>
    <message>
        <source>it belongs to another painting</source>
        <translation>別の絵のものです</translation>
    </message>
    <message>
        <source>it has too many steps</source>
        <translation>ステップが多すぎます</translation>
    </message>
    <message>
        <source>step %1 is damaged</source>
        <translation>ステップ %1 が破損しています</translation>
    </message>
    <message>
        <source>step %1 does not fit the painting</source>
        <translation>ステップ %1 が絵に合いません</translation>
    </message>
    <message>
        <source>the undo history was left out: %1</source>
        <translation>取り消し履歴は省かれました: %1</translation>
    </message>
    <message>
        <source>chunk %1 at byte %2: %3</source>
        <translation>チャンク %1（バイト %2）: %3</translation>
    </message>
    <message>
        <source>is cut off after %1 bytes</source>
        <translation>%1 バイトで途切れています</translation>
    </message>
    <message>
        <source>byte %1: %2</source>
        <translation>バイト %1: %2</translation>
    </message>
    <message>
        <source>is damaged, and nothing in it is whole (%1); take a backup copy</source>
        <translation>破損しており、無事な部分がありません（%1）。バックアップを使ってください</translation>
    </message>
    <message>
        <source>the canvas, paper, groups, swatches and underlay are missing; the canvas is a usual one</source>
        <translation>キャンバス、紙、グループ、スウォッチ、下絵がありません。標準のキャンバスになります</translation>
    </message>
    <message>
        <source>the image of the paper is missing; there is no paper now</source>
        <translation>紙の画像がありません。紙はなくなりました</translation>
    </message>
    <message>
        <source>the underlay is missing</source>
        <translation>下絵がありません</translation>
    </message>
    <message>
        <source>%1 strokes with %2 segments are here; how many there were is not known</source>
        <translation>ストローク %1 本、セグメント %2 個があります。元の数は不明です</translation>
    </message>
    <message>
        <source>%1 of %2 strokes are missing, with %3 of %4 segments</source>
        <translation>ストローク %2 本中 %1 本、セグメント %4 個中 %3 個がありません</translation>
    </message>
    <message>
        <source>all %1 strokes are here</source>
        <translation>ストローク %1 本がすべてあります</translation>
    </message>
    <message>
        <source>%1 strokes are in no group any more</source>
        <translation>ストローク %1 本がグループから外れました</translation>
    </message>
    <message>
        <source>the end of the file is missing</source>
        <translation>ファイルの終わりがありません</translation>
    </message>
    <message>
        <source>the journal cannot be written (%1)</source>
        <translation>ジャーナルに書き込めません（%1）</translation>
    </message>
    <message>
        <source>is not a journal of Suffuse</source>
        <translation>Suffuse のジャーナルではありません</translation>
    </message>
    <message>
        <source>ends before its first painting was written</source>
        <translation>最初の絵が書き込まれる前に終わっています</translation>
    </message>
    <message>
        <source>was written by a newer program (%1); update Suffuse</source>
        <translation>より新しいプログラム（%1）で書き込まれています。Suffuse を更新してください</translation>
    </message>
    <message>
        <source>Suffuse reads .suffuse, its text form (.json), ink as CSV, Universal Ink, InkML, Excalidraw, MyPaint events, Xournal++, Rnote, SVG and diffusion curves (XML)</source>
        <translation>Suffuse が読み込めるのは、.suffuse、そのテキスト形式 (.json)、CSV のインク、Universal Ink、InkML、Excalidraw、MyPaint イベント、Xournal++、Rnote、SVG、拡散曲線 (XML) です</translation>
    </message>
    <message>
        <source>SVG drawing</source>
        <translation>SVG ベクター画像</translation>
    </message>
    <message>
        <source>the drawing is %1 × %2 units large; at most 1e6 are possible, scale it down</source>
        <translation>ベクター画像の大きさが %1 × %2 単位あります。上限は 1e6 です。縮小してください</translation>
    </message>
    <message>
        <source>holds no paths that can be painted; in the program that drew it, turn text and images into paths first</source>
        <translation>描けるパスがありません。先に作成元のプログラムで、テキストと画像をパスに変換してください</translation>
    </message>
    <message>
        <source>the preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>how it was last looked at</source>
        <translation>最後の表示状態</translation>
    </message>
    <message>
        <source>the undo history</source>
        <translation>取り消し履歴</translation>
    </message>
    <message>
        <source>the end of the file is damaged</source>
        <translation>ファイルの終わりが破損しています</translation>
    </message>
    <message>
        <source>the file is damaged or cut off at byte %1</source>
        <translation>ファイルがバイト %1 で破損しているか、途切れています</translation>
    </message>
    <message>
        <source>Damaged and left out: %1. All %2 strokes are here.</source>
        <translation>破損により省いたもの: %1。ストローク %2 本はすべてあります。</translation>
    </message>
    <message>
        <source>damaged and left out: %1</source>
        <translation>破損により省いたもの: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n element(s) not drawn freehand</source>
        <translation>
            <numerusform>手描きでない要素 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>column “%1”</source>
        <translation>列「%1」</translation>
    </message>
    <message numerus="yes">
        <source>%n brush shape(s)</source>
        <translation>
            <numerusform>ブラシ形状 %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n turned or stretched brush tip(s)</source>
        <translation>
            <numerusform>回転または変形した筆先 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>the pen&apos;s azimuths</source>
        <translation>ペンの方位角</translation>
    </message>
    <message numerus="yes">
        <source>%n view(s) of recognised text</source>
        <translation>
            <numerusform>認識されたテキストの表示 %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 were left out.</source>
        <extracomment>%1: a list such as &quot;3 fills, 2 gradients&quot;; the number is that of all things in it.</extracomment>
        <translation>
            <numerusform>%1が省かれました。</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <comment>list</comment>
        <translation>、</translation>
    </message>
    <message numerus="yes">
        <source>%n gradient(s)</source>
        <translation>
            <numerusform>グラデーション %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pattern(s)</source>
        <translation>
            <numerusform>パターン %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n clip path(s)</source>
        <translation>
            <numerusform>クリップパス %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mask(s)</source>
        <translation>
            <numerusform>マスク %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n filter(s)</source>
        <translation>
            <numerusform>フィルター %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n blend mode(s)</source>
        <translation>
            <numerusform>合成モード %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marker(s)</source>
        <translation>
            <numerusform>マーカー %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n intricate outline(s)</source>
        <translation>
            <numerusform>複雑すぎるアウトライン %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n text(s)</source>
        <translation>
            <numerusform>テキスト %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n image(s)</source>
        <translation>
            <numerusform>画像 %n 枚</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n style rule(s)</source>
        <translation>
            <numerusform>スタイルルール %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n &lt;use&gt; of itself</source>
        <translation>
            <numerusform>自身を参照する &lt;use&gt; %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>There is more in the drawing than is read; the rest was left out.</source>
        <translation>ベクター画像の内容が多すぎるため、読み込めない残りは省かれました。</translation>
    </message>
    <message>
        <source>ends after %1 bytes</source>
        <translation>%1 バイトで終わっています</translation>
    </message>
    <message>
        <source>its line endings were changed on the way, transfer it as a binary file</source>
        <translation>転送中に改行コードが変更されています。バイナリファイルとして転送してください</translation>
    </message>
    <message>
        <source>its first bytes are damaged</source>
        <translation>最初のバイトが破損しています</translation>
    </message>
    <message>
        <source>the first bytes of the file</source>
        <translation>ファイルの最初のバイト</translation>
    </message>
    <message>
        <source>version: %1 does not know all that strokes have here; write %2</source>
        <translation>version: %1 では、ここのストロークの内容すべてを表せません。%2 と書いてください</translation>
    </message>
    <message>
        <source>%1 is newer than this program, which reads up to version %2; update Suffuse</source>
        <translation>%1 はこのプログラムより新しいバージョンです。読み込めるのは %2 までです。Suffuse を更新してください</translation>
    </message>
    <message>
        <source>This file is empty: nothing was saved in it.</source>
        <translation>このファイルは空です。何も保存されていません。</translation>
    </message>
    <message>
        <source>This is UTF-16 text. Save it as UTF-8.</source>
        <translation>これは UTF-16 のテキストです。UTF-8 で保存してください。</translation>
    </message>
    <message>
        <source>This is a picture, not a painting. %1.</source>
        <translation>これは画像であり、絵ではありません。%1。</translation>
    </message>
    <message>
        <source>This is neither a painting nor a recording that can be read. %1. Other programs can export SVG.</source>
        <translation>これは読み込める絵でも記録でもありません。%1。ほかのプログラムからは SVG をエクスポートできます。</translation>
    </message>
    <message numerus="yes">
        <source>%n fill(s)</source>
        <translation>
            <numerusform>塗り %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Other fonts stand in for those that are not installed: %1.</source>
        <translation>インストールされていないフォントは、別のフォントで代用されます: %1。</translation>
    </message>
    <message numerus="yes">
        <source>%n text(s) came in as letters: they cannot be typed in again.</source>
        <translation>
            <numerusform>テキスト %n 個は文字の形で取り込まれました。文字の入力はできません。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>the images of %n image layer(s) are missing</source>
        <translation>
            <numerusform>画像レイヤー %n 枚の画像がありません</numerusform>
        </translation>
    </message>
    <message>
        <source>This OpenRaster file is damaged: it has no list of its parts.</source>
        <translation>この OpenRaster ファイルは破損しています: 構成部品の一覧がありません。</translation>
    </message>
    <message>
        <source>OpenRaster picture</source>
        <translation>OpenRaster 画像</translation>
    </message>
    <message>
        <source>Another program changed this picture. What was opened is the painting as Suffuse exported it.</source>
        <translation>別のプログラムがこの画像を変更しました。開いたのは、Suffuse がエクスポートしたときの絵です。</translation>
    </message>
    <message>
        <source>The linked picture %1 is missing, and is not seen: put its file back, or link another one in the Inspector.</source>
        <translation>リンクされた画像 %1 がないため、表示されません。ファイルを元に戻すか、インスペクターで別の画像にリンクしてください。</translation>
    </message>
    <message>
        <source>The linked picture %1 has more than 64 MB, and is not seen.</source>
        <translation>リンクされた画像 %1 は 64 MB を超えているため、表示されません。</translation>
    </message>
    <message>
        <source>The linked picture %1 has changed since it was linked, and is not seen: link it anew in the Inspector.</source>
        <translation>リンクされた画像 %1 は、リンク後に変更されたため、表示されません。インスペクターでリンクし直してください。</translation>
    </message>
    <message numerus="yes">
        <source>So it is with %n other picture(s).</source>
        <translation>
            <numerusform>ほかの画像 %n 枚も同様です。</numerusform>
        </translation>
    </message>
    <message>
        <source>This file is compressed with gzip, and what is in it is neither an SVG nor a notebook of Xournal++ or Rnote. Unpack it first. %1.</source>
        <translation>このファイルは gzip で圧縮されており、中身は SVG でも Xournal++ や Rnote のノートでもありません。先に展開してください。%1。</translation>
    </message>
    <message>
        <source>Another program has changed the drawing since Suffuse wrote it. It is opened as it is drawn now, not as the painting that is in it.</source>
        <translation>Suffuse が書き込んだ後に、別のプログラムがベクター画像を変更しました。中の絵としてではなく、今の描画内容のまま開きました。</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>メモリが足りません</translation>
    </message>
    <message>
        <source>is too large once it is unpacked</source>
        <translation>展開すると大きすぎます</translation>
    </message>
    <message>
        <source>is damaged: it cannot be unpacked</source>
        <translation>破損しています。展開できません</translation>
    </message>
    <message>
        <source>the colour profile</source>
        <translation>カラープロファイル</translation>
    </message>
    <message>
        <source>the size on paper</source>
        <translation>印刷サイズ</translation>
    </message>
    <message>
        <source>the first element is not xournal</source>
        <translation>最初の要素が xournal ではありません</translation>
    </message>
    <message>
        <source>holds no pages</source>
        <translation>ページがありません</translation>
    </message>
    <message>
        <source>%1 is no number within ±1e7</source>
        <translation>%1 は ±1e7 の範囲の数値ではありません</translation>
    </message>
    <message>
        <source>has more than %1 layers</source>
        <translation>レイヤーが %1 枚を超えています</translation>
    </message>
    <message>
        <source>the page has no size</source>
        <translation>ページに大きさがありません</translation>
    </message>
    <message>
        <source>Page %1</source>
        <translation>ページ %1</translation>
    </message>
    <message>
        <source>Layer %1</source>
        <translation>レイヤー %1</translation>
    </message>
    <message>
        <source>the stroke has an x without y</source>
        <translation>ストロークに、y のない x があります</translation>
    </message>
    <message>
        <source>has more than %1 points</source>
        <translation>点が %1 個を超えています</translation>
    </message>
    <message>
        <source>the stroke has no width</source>
        <translation>ストロークに幅がありません</translation>
    </message>
    <message>
        <source>%1: %2 is no number within ±1e7</source>
        <translation>%1: %2 は ±1e7 の範囲の数値ではありません</translation>
    </message>
    <message>
        <source>Xournal++ notebook</source>
        <translation>Xournal++ ノート</translation>
    </message>
    <message>
        <source>InkML recording</source>
        <translation>InkML の記録</translation>
    </message>
    <message>
        <source>Rnote notebook</source>
        <translation>Rnote ノート</translation>
    </message>
    <message>
        <source>the first element is not ink</source>
        <translation>最初の要素が ink ではありません</translation>
    </message>
    <message>
        <source>its groups are too deep</source>
        <translation>グループの入れ子が深すぎます</translation>
    </message>
    <message>
        <source>a point has more than %1 values</source>
        <translation>値が %1 個を超える点があります</translation>
    </message>
    <message>
        <source>the trace is not a list of points with %1 numbers each, or there are more than %2 points</source>
        <translation>トレースが、数値 %1 個ずつの点のリストではないか、点が %2 個を超えています</translation>
    </message>
    <message>
        <source>the trace has no X and Y</source>
        <translation>トレースに X と Y がありません</translation>
    </message>
    <message>
        <source>a point is farther than 1e7 units away</source>
        <translation>1e7 単位より遠い点があります</translation>
    </message>
    <message>
        <source>holds no notebook that can be read; save it with Rnote 0.5 or later</source>
        <translation>読み込めるノートがありません。Rnote 0.5 以降で保存してください</translation>
    </message>
    <message>
        <source>a point is not two numbers within ±1e7</source>
        <translation>±1e7 の範囲の数値 2 個になっていない点があります</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>数値が %1 個を超えています</translation>
    </message>
    <message>
        <source>is Universal Ink %1.%2; 3.0 and 3.1 can be read</source>
        <translation>Universal Ink %1.%2 です。読み込めるのは 3.0 と 3.1 です</translation>
    </message>
    <message>
        <source>is damaged: a part of it is not whole</source>
        <translation>破損しています。一部が完全ではありません</translation>
    </message>
    <message>
        <source>its part %1 is packed in a way that cannot be read</source>
        <translation>%1 の部分は、読み込めない方法で圧縮されています</translation>
    </message>
    <message numerus="yes">
        <source>%n line style(s)</source>
        <translation>
            <numerusform>線のスタイル %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n shape(s)</source>
        <translation>
            <numerusform>図形 %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n way(s) of the pen over the paper</source>
        <translation>
            <numerusform>紙から浮かせたペンの動き %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mapping(s) of channels</source>
        <translation>
            <numerusform>チャンネルの変換 %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n recording(s) of sound</source>
        <translation>
            <numerusform>録音 %n 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n ruled or printed paper(s)</source>
        <translation>
            <numerusform>罫線または印刷入りの用紙 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>a part of Suffuse, %1, %2; install Suffuse again. It is for PDF files alone</source>
        <translation>Suffuse の構成部品 %1: %2。Suffuse をインストールし直してください。これは PDF ファイルにだけ使われます</translation>
    </message>
    <message>
        <source>cannot be loaded (%1)</source>
        <translation>読み込めません（%1）</translation>
    </message>
    <message>
        <source>is of another version of Suffuse</source>
        <translation>Suffuse の別のバージョンのものです</translation>
    </message>
    <message>
        <source>would have more than 2 GB</source>
        <translation>2 GB を超えてしまいます</translation>
    </message>
    <message>
        <source>could not be written: %1</source>
        <translation>書き込めませんでした: %1</translation>
    </message>
    <message numerus="yes">
        <source>Of %n painting(s) in this PDF file the first one was opened.</source>
        <translation>
            <numerusform>この PDF ファイルの %n 点の絵のうち、最初のものを開きました。</numerusform>
        </translation>
    </message>
    <message>
        <source>PDF file</source>
        <translation>PDF ファイル</translation>
    </message>
    <message>
        <source>This is a PDF file, and %1.</source>
        <translation>これは PDF ファイルです。%1。</translation>
    </message>
    <message>
        <source>This PDF file is damaged: %1.</source>
        <translation>この PDF ファイルは破損しています: %1。</translation>
    </message>
    <message>
        <source>This PDF file holds no painting. Suffuse opens those that it wrote; open a picture of its pages as a layer instead.</source>
        <translation>この PDF ファイルには絵がありません。Suffuse で開けるのは、Suffuse が書き込んだものです。代わりに、ページの画像をレイヤーとして開いてください。</translation>
    </message>
    <message>
        <source>Another program changed this PDF file. What was opened is the painting as Suffuse exported it.</source>
        <translation>別のプログラムがこの PDF ファイルを変更しました。開いたのは、Suffuse がエクスポートしたときの絵です。</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupCells</name>
    <message>
        <source>Clipped to what lies below it in its group</source>
        <translation>グループ内の下のものでクリッピング</translation>
    </message>
    <message>
        <source>A mask for the others in its group</source>
        <translation>グループ内のほかのもののマスク</translation>
    </message>
    <message>
        <source>A wash: its strokes are one</source>
        <translation>ウォッシュ：ストロークが一体になっています</translation>
    </message>
    <message>
        <source>Shown alone</source>
        <translation>単独表示</translation>
    </message>
    <message>
        <source>A draft: left out of what is exported</source>
        <translation>下描き：エクスポートに含まれません</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupHand</name>
    <message>
        <source>The group is locked: nothing changes.</source>
        <translation>グループがロックされているため、何も変わりません。</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>グループの不透明度を変更</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>グループの合成モードを変更</translation>
    </message>
    <message>
        <source>Opacity of the group</source>
        <translation>グループの不透明度</translation>
    </message>
</context>
<context>
    <name>suffuse::HintLabel</name>
    <message>
        <source>Hint</source>
        <translation>ヒント</translation>
    </message>
</context>
<context>
    <name>suffuse::HistoryPanel</name>
    <message>
        <source>Start</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Every change since the painting was opened. Click one to go back or forward to it.</source>
        <translation>絵を開いてからのすべての変更。クリックすると、その時点に戻るか進みます。</translation>
    </message>
    <message>
        <source>This stroke</source>
        <translation>このストローク</translation>
    </message>
</context>
<context>
    <name>suffuse::Importing</name>
    <message>
        <source>Picture to Strokes</source>
        <translation>画像をストロークに変換</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>下絵をインポート</translation>
    </message>
    <message>
        <source>Import Strokes</source>
        <translation>ストロークをインポート</translation>
    </message>
    <message>
        <source>“%1” is damaged. What is whole of it was imported.</source>
        <translation>「%1」は破損しています。無事な部分をインポートしました。</translation>
    </message>
    <message>
        <source>Import picture as layer</source>
        <translation>画像をレイヤーとしてインポート</translation>
    </message>
    <message>
        <source>Add as &amp;Layer</source>
        <translation>レイヤーとして追加(&amp;L)</translation>
    </message>
    <message>
        <source>Use as &amp;Underlay</source>
        <translation>下絵として使用(&amp;U)</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
</context>
<context>
    <name>suffuse::InspectorPanel</name>
    <message>
        <source>Nothing is selected. Click a stroke to see and change its values.</source>
        <translation>何も選択されていません。ストロークをクリックすると、値を確認して変更できます。</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>セグメント %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Along the Stroke…</source>
        <translation>ストロークに沿って…</translation>
    </message>
    <message>
        <source>Sets a value along the stroke: constant, as a ramp, or drawn as a curve.</source>
        <translation>ストロークに沿った値を、一定、直線変化、または手描きの曲線で設定します。</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %Ln segment(s)</source>
        <translation>
            <numerusform>%Ln 個のセグメント中 %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasing segment(s)</source>
        <translation>
            <numerusform>消去セグメント %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>They make paint paler.</source>
        <translation>絵の具を薄くします。</translation>
    </message>
    <message>
        <source>They take paint away: the more density, the more.</source>
        <translation>絵の具を取り除きます。濃度が高いほど多く取り除きます。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln of them take(s) paint away.</source>
        <translation>
            <numerusform>そのうち %Ln 個は絵の具を取り除きます。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::KeyboardFocus</name>
    <message>
        <source>The %1 dock has the keyboard; Esc gives it back to the canvas.</source>
        <translation>%1 ドックにキーボードフォーカスがあります。Esc でキャンバスに戻ります。</translation>
    </message>
    <message>
        <source>The canvas has the keyboard.</source>
        <translation>キャンバスにキーボードフォーカスがあります。</translation>
    </message>
    <message>
        <source>The tool bar “%1” has the keyboard; Esc gives it back to the canvas.</source>
        <translation>ツールバー「%1」にキーボードフォーカスがあります。Esc でキャンバスに戻ります。</translation>
    </message>
</context>
<context>
    <name>suffuse::KnifeTool</name>
    <message>
        <source>Drag a line to insert nodes where it crosses strokes. Shift: cut the strokes apart. Ctrl: steps of 15°.</source>
        <translation>線をドラッグすると、ストロークと交わる所にノードを挿入。Shift：ストロークを切断。Ctrl：15° 刻み。</translation>
    </message>
    <message>
        <source>Cut strokes</source>
        <translation>ストロークを切断</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>ノードを挿入</translation>
    </message>
    <message>
        <source>%1 cut into %2</source>
        <extracomment>what the knife did; %1: &quot;2 strokes&quot;, %2: &quot;5 parts&quot;</extracomment>
        <translation>%1を%2に切断しました</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln part(s)</source>
        <translation>
            <numerusform>部分 %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 inserted in %2</source>
        <extracomment>what the knife did; %1: &quot;3 nodes&quot;, %2: &quot;2 strokes&quot;</extracomment>
        <translation>%2に%1を挿入しました</translation>
    </message>
    <message numerus="yes">
        <source>%Ln node(s)</source>
        <translation>
            <numerusform>ノード %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>There are nodes already where the line crosses strokes.</source>
        <translation>線がストロークと交わる所には、すでにノードがあります。</translation>
    </message>
    <message>
        <source>The line crosses no stroke.</source>
        <translation>線がストロークと交わっていません。</translation>
    </message>
    <message>
        <source>The line crosses no selected stroke.</source>
        <translation>線が選択したストロークと交わっていません。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <comment>in</comment>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
    <message>
        <source>A fill is cut only where the line goes all the way through it.</source>
        <translation>塗りは、線が完全に横切る所でだけ切断されます。</translation>
    </message>
    <message>
        <source>Inserts nodes where a line crosses strokes; with Shift it cuts them apart there.</source>
        <translation>線がストロークと交わる所にノードを挿入します。Shift でその位置で切断します。</translation>
    </message>
</context>
<context>
    <name>suffuse::MainWindow</name>
    <message>
        <source>Tool Options</source>
        <translation>ツールオプション</translation>
    </message>
</context>
<context>
    <name>suffuse::MixingSection</name>
    <message>
        <source>Mixing</source>
        <translation>混色</translation>
    </message>
    <message>
        <source>Paint colours over each other here. Shift+drag rubs, Ctrl+click picks.</source>
        <translation>ここで色を重ねて塗ります。Shift+ドラッグでこすり、Ctrl+クリックで採取します。</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>塗る</translation>
    </message>
    <message>
        <source>Paints with the current colour.</source>
        <translation>現在の色で塗ります。</translation>
    </message>
    <message>
        <source>Rub</source>
        <translation>こする</translation>
    </message>
    <message>
        <source>Carries the paint under the pointer along.</source>
        <translation>ポインターの下の絵の具を引きずります。</translation>
    </message>
    <message>
        <source>Pick</source>
        <translation>採取</translation>
    </message>
    <message>
        <source>Makes the colour under the pointer the current one.</source>
        <translation>ポインターの下の色を現在の色にします。</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>消去</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>白紙に戻します。</translation>
    </message>
</context>
<context>
    <name>suffuse::MomentRow</name>
    <message>
        <source>Moment</source>
        <translation>時点</translation>
    </message>
    <message>
        <source>All dried</source>
        <translation>すべて乾いた状態</translation>
    </message>
    <message>
        <source>As it looks now</source>
        <translation>今の見た目</translation>
    </message>
    <message>
        <source>At the time</source>
        <translation>指定の時点</translation>
    </message>
    <message>
        <source>The finished painting, the moment that the canvas shows, or any other.</source>
        <translation>完成した絵、キャンバスに表示中の時点、または任意の時点。</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Minutes and seconds, as the timeline shows them: 1:02.345</source>
        <translation>分と秒（タイムラインの表示と同じ形式）：1:02.345</translation>
    </message>
</context>
<context>
    <name>suffuse::NewDialog</name>
    <message>
        <source>Custom</source>
        <translation>カスタム</translation>
    </message>
    <message>
        <source>Swap width and height</source>
        <translation>幅と高さを入れ替え</translation>
    </message>
    <message>
        <source>C&amp;reate</source>
        <translation>作成(&amp;R)</translation>
    </message>
    <message>
        <source>New Painting</source>
        <translation>新しい絵</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>Usual sizes, and sheets with a ground of their own</source>
        <translation>一般的なサイズと、独自の下地を持つ用紙</translation>
    </message>
    <message>
        <source>Sides in</source>
        <translation>辺の単位</translation>
    </message>
    <message>
        <source>Pixels</source>
        <translation>ピクセル</translation>
    </message>
    <message>
        <source>Millimetres</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>Inches</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>What width and height are given in. A pixel is a unit of the canvas.</source>
        <translation>幅と高さの単位。1 ピクセルはキャンバスの 1 単位です。</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>解像度</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels for each inch of paper. The sheet stays as large on paper.</source>
        <translation>紙 1 インチあたりのピクセル数。用紙の印刷サイズは変わりません。</translation>
    </message>
</context>
<context>
    <name>suffuse::NextNodeFields</name>
    <message>
        <source>X</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Where the next node is set, from the left. Return sets it, and so does a click</source>
        <translation>次のノードの位置、左から。Enter またはクリックで置きます</translation>
    </message>
    <message>
        <source>Y</source>
        <extracomment>of the next node of an outline</extracomment>
        <translation>Y</translation>
    </message>
    <message>
        <source>Where the next node is set, from the top. Return sets it, and so does a click</source>
        <translation>次のノードの位置、上から。Enter またはクリックで置きます</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>From the last node to the next one. Return sets it, and so does a click</source>
        <translation>最後のノードから次のノードまで。Enter またはクリックで置きます</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Direction from the last node to the next one, clockwise from the right. Return sets it, and so does a click</source>
        <translation>最後のノードから次のノードへの方向（右から時計回り）。Enter またはクリックで置きます</translation>
    </message>
    <message>
        <source>Close</source>
        <extracomment>closes an outline</extracomment>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Closes the outline at its first node (Shift+Return)</source>
        <translation>アウトラインを最初のノードで閉じます（Shift+Enter）</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeCommands</name>
    <message>
        <source>The joined stroke has the upper one&apos;s fill. Undo brings the other back.</source>
        <translation>接続したストロークは上のストロークの塗りになります。「元に戻す」でもう一方が戻ります。</translation>
    </message>
    <message>
        <source>The joined stroke has no fill, as the upper one had none. Undo brings the lower one&apos;s back.</source>
        <translation>上のストロークに塗りがないため、接続したストロークにも塗りがありません。「元に戻す」で下の塗りが戻ります。</translation>
    </message>
    <message>
        <source>Smooth nodes</source>
        <translation>ノードをスムーズに</translation>
    </message>
    <message>
        <source>Symmetric nodes</source>
        <translation>ノードを対称に</translation>
    </message>
    <message>
        <source>Corner nodes</source>
        <translation>ノードをシャープに</translation>
    </message>
    <message>
        <source>Insert nodes</source>
        <translation>ノードを挿入</translation>
    </message>
    <message>
        <source>Break stroke</source>
        <translation>ストロークを切り離す</translation>
    </message>
    <message>
        <source>Join nodes</source>
        <translation>ノードを接続</translation>
    </message>
    <message>
        <source>Reverse strokes</source>
        <translation>ストロークの向きを反転</translation>
    </message>
    <message>
        <source>Delete nodes</source>
        <translation>ノードを削除</translation>
    </message>
    <message>
        <source>Delete segments</source>
        <translation>セグメントを削除</translation>
    </message>
    <message>
        <source>Bridge segments</source>
        <translation>セグメントを橋渡し</translation>
    </message>
    <message>
        <source>A node alone has no paint: select the nodes at both ends of a segment, or take the whole stroke with the Select tool.</source>
        <translation>ノードだけでは絵の具がありません。セグメントの両端のノードを選択するか、選択ツールでストローク全体を選択してください。</translation>
    </message>
    <message>
        <source>The closed outline begins and ends at this node, so it has nothing more to break. Delete Segments (Ctrl+Del) opens it.</source>
        <translation>閉じたアウトラインはこのノードで始まり、終わっているため、これ以上切り離せません。「セグメントを削除」（Ctrl+Delete）で開きます。</translation>
    </message>
    <message>
        <source>Join needs two ends of strokes: select one, and Shift+click the other or drag around both.</source>
        <translation>接続にはストロークの端が 2 つ必要です。一方を選択し、もう一方を Shift+クリックするか、両方をドラッグで囲んでください。</translation>
    </message>
    <message>
        <source>These two ends cannot be joined.</source>
        <translation>この 2 つの端は接続できません。</translation>
    </message>
</context>
<context>
    <name>suffuse::NodeTool</name>
    <message>
        <source>Drag the handle to bend the curve. Shift: make the node a corner. Ctrl: steps of 15°.</source>
        <translation>ハンドルをドラッグして曲線を曲げます。Shift：ノードをシャープに。Ctrl：15° 刻み。</translation>
    </message>
    <message>
        <source>Insert node</source>
        <translation>ノードを挿入</translation>
    </message>
    <message>
        <source>Move nodes</source>
        <translation>ノードを移動</translation>
    </message>
    <message>
        <source>Move node</source>
        <translation>ノードを移動</translation>
    </message>
    <message>
        <source>Click a segment to select it, Shift+click for a run or another stroke&apos;s, Ctrl+click to add or remove one. Drag around nodes.</source>
        <translation>クリックでセグメントを選択、Shift+クリックで連続または別のストロークのもの、Ctrl+クリックで 1 つ追加・除外。ノードはドラッグで囲みます。</translation>
    </message>
    <message>
        <source>Drag to move nodes, softly within the reach (wheel, Alt+drag). Ctrl: along an axis, Ctrl+Alt: the handle. Shift+click for more.</source>
        <translation>ドラッグでノードを移動、影響範囲内を滑らかに（ホイール、Alt+ドラッグ）。Ctrl：軸に沿って。Ctrl+Alt：ハンドル。Shift+クリックで追加。</translation>
    </message>
    <message>
        <source>Drag to bend the curve within the reach (wheel, Alt+drag). Double click to insert a node. Click to select the segment.</source>
        <translation>ドラッグで影響範囲内の曲線を曲げます（ホイール、Alt+ドラッグ）。ダブルクリックでノードを挿入。クリックでセグメントを選択。</translation>
    </message>
    <message>
        <source>Move erasure</source>
        <translation>消し跡を移動</translation>
    </message>
    <message>
        <source>Move the erasure: it takes away where it lies. Ctrl: along an axis. Esc gives it up.</source>
        <translation>消し跡を移動します。置いた所の絵の具を取り除きます。Ctrl：軸に沿って。Esc で中止。</translation>
    </message>
    <message>
        <source>Drag to move the erasure. Click to select it in all strokes, again for its part in this one, again for a segment. Delete removes it.</source>
        <translation>ドラッグで消し跡を移動。クリックで全ストローク分、もう一度でこのストロークの分、さらにもう一度でセグメントを選択。Delete で削除。</translation>
    </message>
    <message>
        <source>Move segments</source>
        <translation>セグメントを移動</translation>
    </message>
    <message>
        <source>An end of a gradient is not deleted alone. Remove, beside Gradient in the Inspector, takes the gradient away; Esc first, and Delete means the stroke.</source>
        <translation>グラデーションの端だけは削除できません。インスペクターのグラデーションの横にある「削除」で取り除きます。Esc を押した後の Delete はストロークが対象です。</translation>
    </message>
    <message>
        <source>What was selected is deleted; its strokes are merely shown. Click what else is to go, or take whole strokes with the Select tool.</source>
        <translation>選択していたものは削除されました。そのストロークは表示されているだけです。ほかに削除するものをクリックするか、選択ツールでストローク全体を選択してください。</translation>
    </message>
</context>
<context>
    <name>suffuse::NumberField</name>
    <message>
        <source>“%1” is not a number. Sums such as 12*1.5 or +2 work too.</source>
        <translation>「%1」は数値ではありません。12*1.5 や +2 のような計算式も使えます。</translation>
    </message>
    <message>
        <source>%1 is out of range: %2 to %3 is possible.</source>
        <translation>%1 は範囲外です。%2～%3 を指定できます。</translation>
    </message>
    <message>
        <source>“%1” is not possible here: this number has no unit.</source>
        <translation>ここでは「%1」は使えません。この数値に単位はありません。</translation>
    </message>
    <message>
        <source>“%1” is not possible here: the unit is %2.</source>
        <translation>ここでは「%1」は使えません。単位は %2 です。</translation>
    </message>
    <message>
        <source> u</source>
        <translation> u</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source> in</source>
        <translation> in</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source> u²/s</source>
        <translation> u²/s</translation>
    </message>
    <message>
        <source>%1 is out of range: more than 0 and up to %2 is possible.</source>
        <translation>%1 は範囲外です。0 より大きく %2 以下を指定できます。</translation>
    </message>
    <message>
        <source>%1 is the most that is possible.</source>
        <translation>上限は %1 です。</translation>
    </message>
    <message>
        <source>%1 is the least that is possible.</source>
        <translation>下限は %1 です。</translation>
    </message>
</context>
<context>
    <name>suffuse::PanTool</name>
    <message>
        <source>Drag to move the canvas. The wheel zooms; R and drag turns.</source>
        <translation>ドラッグでキャンバスを移動。ホイールでズーム、R を押しながらドラッグで回転。</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPad</name>
    <message>
        <source>Try your pen here.</source>
        <translation>ここでペンを試せます。</translation>
    </message>
</context>
<context>
    <name>suffuse::PenPage</name>
    <message>
        <source>Pressure</source>
        <translation>筆圧</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>ソフト</translation>
    </message>
    <message>
        <source>Even</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>Firm</source>
        <translation>ハード</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>カスタム</translation>
    </message>
    <message>
        <source>How hard the pen must be pressed, for all brushes.</source>
        <translation>ペンを押す強さの感度。全ブラシに共通です。</translation>
    </message>
    <message>
        <source>Takes a clean sheet.</source>
        <translation>白紙に戻します。</translation>
    </message>
    <message>
        <source>pressure of the pen →</source>
        <translation>ペンの筆圧 →</translation>
    </message>
    <message>
        <source>↑ paints with</source>
        <translation>↑ 描画の筆圧</translation>
    </message>
    <message>
        <source>Pressure curve</source>
        <translation>筆圧曲線</translation>
    </message>
    <message>
        <source>Drag the points; click for another; drag one out to take it away.</source>
        <translation>点をドラッグ。クリックで追加、外へドラッグで削除。</translation>
    </message>
    <message>
        <source>Paint here with the brush in use; the dot on the curve is the pen&apos;s pressure.</source>
        <translation>使用中のブラシでここに描きます。曲線上のドットはペンの筆圧です。</translation>
    </message>
    <message>
        <source>Only the pen and the mouse paint; fingers move the view</source>
        <translation>ペンとマウスだけで描き、指では表示を動かす</translation>
    </message>
    <message>
        <source>One finger moves the canvas, two zoom and turn it. Otherwise one finger paints.</source>
        <translation>1 本指でキャンバスを移動、2 本指でズームと回転。オフの場合、1 本指で描きます。</translation>
    </message>
    <message>
        <source>C&amp;lear</source>
        <translation>消去(&amp;L)</translation>
    </message>
</context>
<context>
    <name>suffuse::PresetRow</name>
    <message>
        <source>Preset</source>
        <translation>プリセット</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Format, depth, quality, resolution, size, area and moment under a name</source>
        <translation>形式、色深度、画質、解像度、サイズ、範囲、時点に名前を付けたもの</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Keep what is set here as a preset</source>
        <translation>ここの設定をプリセットとして保存します</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>削除(&amp;R)</translation>
    </message>
    <message>
        <source>Forget the chosen preset</source>
        <translation>選んだプリセットを削除します</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>There is a preset “%1”. Replace it?</source>
        <translation>プリセット「%1」はすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>Save Preset</source>
        <translation>プリセットを保存</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintDialog</name>
    <message>
        <source>Print</source>
        <translation>印刷</translation>
    </message>
    <message>
        <source>&amp;Print</source>
        <translation>印刷(&amp;P)</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Prints the canvas's colour; without it the paint lies on the paper as it is.</source>
        <translation>キャンバスの色を印刷します。オフの場合は、絵の具だけが用紙に印刷されます。</translation>
    </message>
    <message>
        <source>Print to File (PDF)</source>
        <translation>ファイルに印刷（PDF）</translation>
    </message>
    <message>
        <source>Printer</source>
        <translation>プリンター</translation>
    </message>
    <message>
        <source>Where the page comes out</source>
        <translation>ページの出力先</translation>
    </message>
    <message>
        <source>No printer is set up on this computer. A file can be printed elsewhere.</source>
        <translation>このコンピューターにはプリンターが設定されていません。ファイルなら、ほかの場所で印刷できます。</translation>
    </message>
    <message>
        <source>The PDF file that is written: one page as large as the paper.</source>
        <translation>書き込む PDF ファイル。用紙と同じ大きさの 1 ページです。</translation>
    </message>
    <message>
        <source>Copies</source>
        <translation>部数</translation>
    </message>
    <message>
        <source>How often the page is printed</source>
        <translation>ページを印刷する回数</translation>
    </message>
    <message>
        <source>%1 – %2 × %3 mm</source>
        <translation>%1 – %2 × %3 mm</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>用紙と同じ大きさ</translation>
    </message>
    <message>
        <source>Upright</source>
        <translation>縦</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>横</translation>
    </message>
    <message>
        <source>Orientation</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>How the paper lies</source>
        <translation>用紙の向き</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>用紙</translation>
    </message>
    <message>
        <source>The size of the paper</source>
        <translation>用紙のサイズ</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>下</translation>
    </message>
    <message>
        <source>Left margin</source>
        <translation>左の余白</translation>
    </message>
    <message>
        <source>Top margin</source>
        <translation>上の余白</translation>
    </message>
    <message>
        <source>Right margin</source>
        <translation>右の余白</translation>
    </message>
    <message>
        <source>Bottom margin</source>
        <translation>下の余白</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>What stays empty at this edge of the paper</source>
        <translation>用紙のこの端で空けておく幅</translation>
    </message>
    <message>
        <source>Margins</source>
        <translation>余白</translation>
    </message>
    <message>
        <source>Fit to the page</source>
        <translation>ページに合わせる</translation>
    </message>
    <message>
        <source>Actual size</source>
        <translation>実際のサイズ</translation>
    </message>
    <message>
        <source>Scaled</source>
        <translation>倍率を指定</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>倍率</translation>
    </message>
    <message>
        <source>Of the actual size</source>
        <translation>実際のサイズに対する割合</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>How large the picture lies on the paper</source>
        <translation>用紙の上での画像の大きさ</translation>
    </message>
    <message>
        <source>%1 dpi</source>
        <translation>%1 dpi</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>解像度</translation>
    </message>
    <message>
        <source>How many dots an inch the picture is drawn with</source>
        <translation>画像を描画する 1 インチあたりのドット数</translation>
    </message>
    <message>
        <source>Usual: %1 dpi</source>
        <translation>標準：%1 dpi</translation>
    </message>
    <message>
        <source>The printer's: %1 dpi</source>
        <translation>プリンターの解像度：%1 dpi</translation>
    </message>
    <message>
        <source>The margins leave no room on the paper.</source>
        <translation>余白が大きすぎて、用紙に印刷する場所がありません。</translation>
    </message>
    <message>
        <source>The picture is %1 × %2 mm on the paper.</source>
        <translation>画像は用紙の上で %1 × %2 mm です。</translation>
    </message>
    <message>
        <source>What does not fit is cut off.</source>
        <translation>収まらない部分は切り取られます。</translation>
    </message>
    <message>
        <source>PDF files</source>
        <translation>PDF ファイル</translation>
    </message>
    <message>
        <source>“%1” is not there any more. Choose another printer.</source>
        <translation>「%1」が見つからなくなりました。別のプリンターを選んでください。</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintJob</name>
    <message>
        <source>The page does not fit into memory.</source>
        <translation>ページがメモリに収まりません。</translation>
    </message>
    <message>
        <source>There is no room for the page on the disk: %1</source>
        <translation>ディスクにページを書き込む空きがありません：%1</translation>
    </message>
    <message>
        <source>The printer does not take the page. See whether it is there, or print to a file.</source>
        <translation>プリンターがページを受け付けません。プリンターがあるか確かめるか、ファイルに印刷してください。</translation>
    </message>
</context>
<context>
    <name>suffuse::PrintRows</name>
    <message>
        <source>Print size</source>
        <translation>印刷サイズ</translation>
    </message>
    <message>
        <source>Width on paper</source>
        <translation>印刷時の幅</translation>
    </message>
    <message>
        <source>Width on paper; the height and the pixels follow.</source>
        <translation>印刷時の幅。高さとピクセル数は自動で決まります。</translation>
    </message>
    <message>
        <source>Height on paper</source>
        <translation>印刷時の高さ</translation>
    </message>
    <message>
        <source>Height on paper; the width and the pixels follow.</source>
        <translation>印刷時の高さ。幅とピクセル数は自動で決まります。</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Millimetres or inches</source>
        <translation>ミリメートルまたはインチ</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>解像度</translation>
    </message>
    <message>
        <source> dpi</source>
        <translation> dpi</translation>
    </message>
    <message>
        <source>Pixels an inch. PNG, TIFF, JPEG and EXR files say it.</source>
        <translation>1 インチあたりのピクセル数。PNG、TIFF、JPEG、EXR ファイルに記されます。</translation>
    </message>
</context>
<context>
    <name>suffuse::ProbePanel</name>
    <message>
        <source>Rest the pointer on the painting: what it is made of there is listed here, and stays when you come here to click it.</source>
        <translation>絵の上でポインターを止めると、そこを構成するものがここに一覧表示されます。ポインターをここへ移しても一覧は残り、クリックできます。</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>割合</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>濃度 φ</translation>
    </message>
    <message>
        <source>Of strokes: share of the colour. Of segments: share of the stroke&apos;s density.</source>
        <translation>ストローク：色に占める割合。セグメント：ストロークの濃度に占める割合。</translation>
    </message>
    <message>
        <source>Strokes under the pointer</source>
        <translation>ポインターの下のストローク</translation>
    </message>
    <message>
        <source>Density over the age</source>
        <translation>経過時間と濃度</translation>
    </message>
    <message>
        <source>The density of the chosen stroke at this place from when it was painted until it is dry. Dashed: the density from which it is seen.</source>
        <translation>選んだストロークの、この場所での濃度。描かれてから乾くまで。破線：見え始める濃度。</translation>
    </message>
    <message>
        <source>%1, %2 · paper η %3</source>
        <translation>%1, %2 · 紙 η %3</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>ストローク %1</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>セグメント %1</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>塗り</translation>
    </message>
    <message>
        <source>The topmost stroke comes first, with its share of the colour.</source>
        <translation>一番上のストロークが先頭です。色に占める割合が付きます。</translation>
    </message>
</context>
<context>
    <name>suffuse::PushTool</name>
    <message>
        <source>Drag to push strokes along. [ and ] change the size.</source>
        <translation>ドラッグでストロークを押し動かします。[ と ] でサイズを変更。</translation>
    </message>
    <message>
        <source>Drag to push the selected strokes along. [ and ] change the size.</source>
        <translation>ドラッグで選択したストロークを押し動かします。[ と ] でサイズを変更。</translation>
    </message>
    <message>
        <source>Drag to turn strokes into the direction of the drag.</source>
        <translation>ドラッグでストロークをその方向に向けます。</translation>
    </message>
    <message>
        <source>Drag to turn the selected strokes into the direction of the drag.</source>
        <translation>ドラッグで選択したストロークをその方向に向けます。</translation>
    </message>
    <message>
        <source>Hold to pull strokes together. Shift: apart.</source>
        <translation>押し続けるとストロークを引き寄せます。Shift：広げる。</translation>
    </message>
    <message>
        <source>Hold to pull the selected strokes together. Shift: apart.</source>
        <translation>押し続けると選択したストロークを引き寄せます。Shift：広げる。</translation>
    </message>
    <message>
        <source>Drag to roughen strokes.</source>
        <translation>ドラッグでストロークを荒らします。</translation>
    </message>
    <message>
        <source>Drag to roughen the selected strokes.</source>
        <translation>ドラッグで選択したストロークを荒らします。</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>押す</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>とかす</translation>
    </message>
    <message>
        <source>Pinch</source>
        <translation>つまむ</translation>
    </message>
    <message>
        <source>Roughen</source>
        <translation>荒らす</translation>
    </message>
    <message>
        <source>What the circle does to strokes</source>
        <translation>円がストロークに及ぼす効果</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>How much of it one touch does; a pen&apos;s pressure takes from it</source>
        <translation>1 回の操作での効果の大きさ。ペンの筆圧が弱いほど小さくなります</translation>
    </message>
    <message>
        <source>Push strokes</source>
        <translation>ストロークを押す</translation>
    </message>
    <message>
        <source>Comb strokes</source>
        <translation>ストロークをとかす</translation>
    </message>
    <message>
        <source>Pinch strokes</source>
        <translation>ストロークをつまむ</translation>
    </message>
    <message>
        <source>Roughen strokes</source>
        <translation>ストロークを荒らす</translation>
    </message>
    <message>
        <source>Letters are left alone while nothing is selected. Select the text to change its letters.</source>
        <translation>何も選択していないとき、文字は変わりません。文字を変えるには、テキストを選択してください。</translation>
    </message>
</context>
<context>
    <name>suffuse::RecolourDialog</name>
    <message>
        <source>Recolour Artwork</source>
        <translation>アートワークを再配色</translation>
    </message>
    <message>
        <source>Colours of what is selected</source>
        <translation>選択したものの色</translation>
    </message>
    <message>
        <source>Colours of the painting</source>
        <translation>絵の色</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>色</translation>
    </message>
    <message>
        <source>The colours with the most paint come first. Choose one, or several, and give it another colour: it changes everywhere.</source>
        <translation>絵の具の多い色から順に並びます。1 つまたは複数を選んで別の色にすると、すべての場所で変わります。</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>変更前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>変更後</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>絵の具量</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>セグメント</translation>
    </message>
    <message numerus="yes">
        <source>%n colours that look alike</source>
        <translation>
            <numerusform>似た色 %n 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Hex</source>
        <translation>Hex</translation>
    </message>
    <message>
        <source>sRGB colour as #rrggbb, #rgb or CSS: rgb(255, 0, 128), hsl(20, 50%, 40%), teal</source>
        <translation>sRGB カラー：#rrggbb、#rgb、または CSS: rgb(255, 0, 128)、hsl(20, 50%, 40%)、teal</translation>
    </message>
    <message>
        <source>Swatches</source>
        <translation>スウォッチ</translation>
    </message>
    <message>
        <source>The swatches of the painting. Click: the chosen colour becomes this one.</source>
        <translation>絵のスウォッチ。クリック：選んだ色がこの色になります。</translation>
    </message>
    <message>
        <source>Keep differences</source>
        <translation>違いを保つ</translation>
    </message>
    <message>
        <source>Colours that are one line in the list change together and stay different. Else they become the same.</source>
        <translation>一覧で 1 行になっている色は、違いを保ったまま一緒に変わります。オフの場合、同じ色になります。</translation>
    </message>
    <message>
        <source>Reset the Colour</source>
        <translation>色をリセット</translation>
    </message>
    <message>
        <source>Gives the chosen colours back what they were</source>
        <translation>選んだ色を元の色に戻します</translation>
    </message>
    <message>
        <source>All colours</source>
        <translation>すべての色</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Turns all hues around the colour wheel</source>
        <translation>すべての色相をカラーサークル上で回転します</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>彩度</translation>
    </message>
    <message>
        <source>100 %: as it is; 0 %: grey; more: more colourful</source>
        <translation>100 %：元のまま。0 %：グレー。100 % 超：より鮮やか</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>明るさ</translation>
    </message>
    <message>
        <source>Above 0 % nearer to white, below nearer to black</source>
        <translation>0 % より上で白に近づき、下で黒に近づきます</translation>
    </message>
    <message>
        <source>Map to the nearest swatches</source>
        <translation>最も近いスウォッチに置き換え</translation>
    </message>
    <message>
        <source>Each colour becomes the swatch of the painting that looks nearest</source>
        <translation>それぞれの色が、最も近く見える絵のスウォッチになります</translation>
    </message>
    <message>
        <source>“%1” is not a colour. Write it as #rrggbb, for example #2f6690.</source>
        <translation>「%1」は色ではありません。#rrggbb の形で入力してください（例：#2f6690）。</translation>
    </message>
</context>
<context>
    <name>suffuse::RecoveryDialog</name>
    <message>
        <source>Recover Paintings</source>
        <translation>絵を復旧</translation>
    </message>
    <message>
        <source>Suffuse ended before these paintings were saved. They open as they were at the last stroke; files on the disk are left as they are.</source>
        <translation>次の絵が保存される前に Suffuse が終了しました。最後のストロークの時点の状態で開きます。ディスク上のファイルは元のままです。</translation>
    </message>
    <message>
        <source>Paintings that can be recovered</source>
        <translation>復旧できる絵</translation>
    </message>
    <message>
        <source>Painting</source>
        <translation>絵</translation>
    </message>
    <message>
        <source>Last Change</source>
        <translation>最終変更</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>フォルダー</translation>
    </message>
    <message>
        <source>&amp;Recover</source>
        <translation>復旧(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>後で(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Discard…</source>
        <translation>破棄(&amp;D)…</translation>
    </message>
    <message>
        <source>Opens the selected paintings, without a file of their own</source>
        <translation>選択した絵を、ファイルなしで開きます</translation>
    </message>
    <message>
        <source>Asks again when Suffuse starts the next time</source>
        <translation>次に Suffuse を起動したときに、もう一度確認します</translation>
    </message>
    <message>
        <source>Removes the selected paintings for good</source>
        <translation>選択した絵を完全に削除します</translation>
    </message>
    <message>
        <source>not saved yet</source>
        <translation>まだ保存されていません</translation>
    </message>
    <message>
        <source>Discard “%1”?</source>
        <translation>「%1」を破棄しますか？</translation>
    </message>
    <message numerus="yes">
        <source>Discard %n paintings?</source>
        <translation>
            <numerusform>絵 %n 点を破棄しますか？</numerusform>
        </translation>
    </message>
    <message>
        <source>What was painted since the last save is then lost for good.</source>
        <translation>前回の保存以降に描いたものは、完全に失われます。</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>破棄(&amp;D)</translation>
    </message>
</context>
<context>
    <name>suffuse::RedrawTool</name>
    <message>
        <source>Draw from a stroke and back to it: the part between follows the line.</source>
        <translation>ストロークから描き始めて同じストロークに戻ると、間の部分がその線に変わります。</translation>
    </message>
    <message>
        <source>Draw from a selected stroke and back to it: the part between follows.</source>
        <translation>選択したストロークから描き始めて同じストロークに戻ると、間の部分が変わります。</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>As they were</source>
        <translation>元のまま</translation>
    </message>
    <message>
        <source>Of the brush in hand</source>
        <translation>使用中のブラシ</translation>
    </message>
    <message>
        <source>What the new part is painted with, and when</source>
        <translation>新しい部分を何で描き、いつ描いたことにするか</translation>
    </message>
    <message>
        <source>Redraw</source>
        <translation>描き直し</translation>
    </message>
    <message>
        <source>The line begins and ends at no stroke that can be changed.</source>
        <translation>線の始まりと終わりに、変更できるストロークがありません。</translation>
    </message>
    <message>
        <source>The line begins and ends at no selected stroke that can be changed.</source>
        <translation>線の始まりと終わりに、変更できる選択したストロークがありません。</translation>
    </message>
</context>
<context>
    <name>suffuse::ReshapeDialog</name>
    <message>
        <source>Reshape</source>
        <translation>形の調整</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>簡略化</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>滑らかに</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>直線に近づける</translation>
    </message>
    <message>
        <source>Grow or shrink</source>
        <translation>太く・細く</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>オフセット</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変更内容</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距離</translation>
    </message>
    <message>
        <source>How far curves may move</source>
        <translation>曲線が動いてよい距離</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>How far spreads, densities, colours and times may differ that become one</source>
        <translation>広がり、濃度、色、時間の違いがどこまでなら 1 つにまとめるか</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Wiggles of this length and shorter ones go</source>
        <translation>この長さ以下の波打ちをなくします</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>量</translation>
    </message>
    <message>
        <source>0 %: as it is; 100 %: a straight line</source>
        <translation>0 %：元のまま。100 %：直線</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Of the paint; below 100 % it shrinks</source>
        <translation>絵の具の幅。100 % 未満で細くなります</translation>
    </message>
    <message>
        <source>To the right of the stroke&apos;s direction; below 0 to the left</source>
        <translation>ストロークの方向に対して右へ。0 未満で左へ</translation>
    </message>
    <message>
        <source>%1 → %2 segments</source>
        <extracomment>%1, %2: numbers of segments before and after</extracomment>
        <translation>%1 → %2 セグメント</translation>
    </message>
    <message>
        <source>%1, picture differs by %2</source>
        <extracomment>%1: &quot;12 → 3 segments&quot;; %2: &quot;0.4 %&quot;, the mean difference of the pictures</extracomment>
        <translation>%1、画像の違い %2</translation>
    </message>
</context>
<context>
    <name>suffuse::RewetRows</name>
    <message>
        <source>Wetted again</source>
        <translation>濡らし直し</translation>
    </message>
    <message>
        <source>… and more</source>
        <translation>… ほか</translation>
    </message>
    <message>
        <source>at %1 for %2 s</source>
        <translation>%1 から %2 s 間</translation>
    </message>
    <message>
        <source>at %1 for %2 s, some segments</source>
        <translation>%1 から %2 s 間、一部のセグメント</translation>
    </message>
    <message>
        <source>The selected paint is not wetted then</source>
        <translation>選択した絵の具は、このときは濡らされません</translation>
    </message>
    <message>
        <source>Remove re-wetting</source>
        <translation>濡らし直しを削除</translation>
    </message>
</context>
<context>
    <name>suffuse::ScreenColourRows</name>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>彩度</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>明度</translation>
    </message>
    <message>
        <source>Hue on the circle of the screen&apos;s colours: 0° red, 120° green, 240° blue</source>
        <translation>画面の色の色相環での色相：0° 赤、120° 緑、240° 青</translation>
    </message>
    <message>
        <source>0 %: grey; 100 %: as colourful as a screen can be</source>
        <translation>0 %：グレー。100 %：画面で最も鮮やかな色</translation>
    </message>
    <message>
        <source>0 %: black; 100 %: as bright as the colour can be</source>
        <translation>0 %：黒。100 %：その色で最も明るい状態</translation>
    </message>
    <message>
        <source>Red light of the screen, 0 to 255</source>
        <translation>画面の赤の光（0～255）</translation>
    </message>
    <message>
        <source>Green light of the screen, 0 to 255</source>
        <translation>画面の緑の光（0～255）</translation>
    </message>
    <message>
        <source>Blue light of the screen, 0 to 255</source>
        <translation>画面の青の光（0～255）</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
</context>
<context>
    <name>suffuse::SegmentSection</name>
    <message>
        <source>Diffusion D</source>
        <translation>拡散 D</translation>
    </message>
    <message>
        <source>How fast the paint spreads: the spread grows with the root of D times time.</source>
        <translation>絵の具が広がる速さ。広がりは D×時間の平方根に比例します。</translation>
    </message>
    <message>
        <source>Density φ</source>
        <translation>濃度 φ</translation>
    </message>
    <message>
        <source>How much paint the segment gives off along its length.</source>
        <translation>セグメントが長さあたりに出す絵の具の量。</translation>
    </message>
    <message>
        <source>Drying time</source>
        <translation>乾燥時間</translation>
    </message>
    <message>
        <source>t_max: how long the paint spreads after it was laid down.</source>
        <translation>t_max: 置かれた絵の具が広がる時間。</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>セグメント</translation>
    </message>
    <message>
        <source>Change diffusion</source>
        <translation>拡散を変更</translation>
    </message>
    <message>
        <source>Change density</source>
        <translation>濃度を変更</translation>
    </message>
    <message>
        <source>Change granulation</source>
        <translation>粒状化を変更</translation>
    </message>
    <message>
        <source>Change drying time</source>
        <translation>乾燥時間を変更</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Colour of the selection</source>
        <translation>選択範囲の色</translation>
    </message>
    <message>
        <source>Colour of the selection. Click: paint with it.</source>
        <translation>選択範囲の色。クリック：この色で描く。</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>不透明度を変更</translation>
    </message>
    <message>
        <source>Change colour</source>
        <translation>色を変更</translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation>異方性</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>角度</translation>
    </message>
    <message>
        <source>Direction of the anisotropy, clockwise from the horizontal.</source>
        <translation>異方性の方向（水平から時計回り）。</translation>
    </message>
    <message>
        <source>Change anisotropy</source>
        <translation>異方性を変更</translation>
    </message>
    <message>
        <source>Change angle</source>
        <translation>角度を変更</translation>
    </message>
    <message>
        <source>How many times D along the angle is D across it; 1 spreads evenly.</source>
        <translation>角度方向の D が、それと直交する方向の D の何倍か。1 で均等に広がります。</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How much the paint covers at full density</source>
        <translation>最大濃度のときに絵の具がどれだけ覆うか</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>Share of red pigment</source>
        <translation>赤の顔料の割合</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>Share of yellow pigment</source>
        <translation>黄の顔料の割合</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>Share of blue pigment</source>
        <translation>青の顔料の割合</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>選択したものすべてには設定できません。範囲外になる値があります。</translation>
    </message>
    <message>
        <source>Born</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>When the stroke, or what is selected of it, begins. All of that moves in time as one.</source>
        <translation>ストロークまたはその選択部分が始まる時間。全体がまとめて移動します。</translation>
    </message>
    <message>
        <source>Change birth</source>
        <translation>開始時間を変更</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 を変更</translation>
    </message>
    <message>
        <source>Granulation</source>
        <translation>粒状化</translation>
    </message>
    <message>
        <source>How much of the paper&apos;s grain shows: 0 % is smooth, 100 % shows all of it. Files and scripts hold ω, which is 1 where this is 0 %.</source>
        <translation>紙目がどれだけ現れるか。0 % で滑らか、100 % ですべて現れます。ファイルとスクリプトでは ω を使い、ここの 0 % が 1 にあたります。</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Width of a dry line at full pressure, in units; sets the diffusion.</source>
        <translation>最大の筆圧で描いて乾いた線の幅（単位）。拡散を決めます。</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>流量</translation>
    </message>
    <message>
        <source>Density in the middle of the stroke at full pressure.</source>
        <translation>最大の筆圧で描いたストロークの中央の濃度。</translation>
    </message>
    <message>
        <source>String</source>
        <translation>ひも</translation>
    </message>
    <message>
        <source>Its length on the screen</source>
        <translation>画面上での長さ</translation>
    </message>
    <message>
        <source>Pigment β</source>
        <translation>顔料 β</translation>
    </message>
    <message>
        <source>Share of the colour below that stays: 0 % covers, 100 % adds.</source>
        <translation>下の色が残る割合：0 % で覆い、100 % で加算。</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>How deep the grain goes.</source>
        <translation>紙目の深さ。</translation>
    </message>
    <message>
        <source>How far the stroke lags behind</source>
        <translation>ストロークの遅れの大きさ</translation>
    </message>
    <message>
        <source>Parameter of the style</source>
        <translation>スタイルのパラメーター</translation>
    </message>
    <message>
        <source>Threshold ξ1</source>
        <translation>しきい値 ξ1</translation>
    </message>
    <message>
        <source>Softness ξ2</source>
        <translation>やわらかさ ξ2</translation>
    </message>
    <message>
        <source>Full at ξ1</source>
        <translation>全被覆 ξ1</translation>
    </message>
    <message>
        <source>Steepness ξ2</source>
        <translation>急峻さ ξ2</translation>
    </message>
    <message>
        <source>Edge ξ1</source>
        <translation>縁 ξ1</translation>
    </message>
    <message>
        <source>Lightening ξ2</source>
        <translation>薄さ ξ2</translation>
    </message>
    <message>
        <source>Strength ξ3</source>
        <translation>強さ ξ3</translation>
    </message>
    <message>
        <source>Density at which the stroke covers by half.</source>
        <translation>ストロークが半分覆う濃度。</translation>
    </message>
    <message>
        <source>How gently the edge fades.</source>
        <translation>縁の消え方のなだらかさ。</translation>
    </message>
    <message>
        <source>Density from which the stroke covers fully.</source>
        <translation>ストロークが完全に覆い始める濃度。</translation>
    </message>
    <message>
        <source>How steeply coverage grows with density.</source>
        <translation>濃度に対する被覆率の増え方の急さ。</translation>
    </message>
    <message>
        <source>Density at which the dark rim stands.</source>
        <translation>濃い縁が現れる濃度。</translation>
    </message>
    <message>
        <source>How much the inside is lighter than the rim; at most 1.26·ξ1.</source>
        <translation>内側が縁よりどれだけ薄いか。最大 1.26·ξ1。</translation>
    </message>
    <message>
        <source>Coverage far inside the stroke.</source>
        <translation>ストロークの十分内側の被覆率。</translation>
    </message>
    <message>
        <source>Uniform</source>
        <translation>均一</translation>
    </message>
    <message>
        <source>Feathering</source>
        <translation>ぼかし</translation>
    </message>
    <message>
        <source>Dark edges</source>
        <translation>濃い縁</translation>
    </message>
    <message>
        <source>Covering (alpha)</source>
        <translation>被覆（アルファ）</translation>
    </message>
    <message>
        <source>Pigment (β)</source>
        <translation>顔料（β）</translation>
    </message>
    <message>
        <source>Erasure</source>
        <translation>消し跡</translation>
    </message>
    <message>
        <source>Off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Weighted</source>
        <translation>加重</translation>
    </message>
    <message>
        <source>Pulled string</source>
        <translation>ひもで引く</translation>
    </message>
</context>
<context>
    <name>suffuse::SelectTool</name>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 under the pointer, from the top. Alt+click again: the next below.</source>
        <translation>ポインターの下のストローク %2 本中、上から %1 本目。もう一度 Alt+クリック：その下。</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>拡大縮小</translation>
    </message>
    <message>
        <source>Skew</source>
        <translation>傾斜</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %3 本中 %2 本目</translation>
    </message>
    <message>
        <source>%1: moved by %2, %3</source>
        <translation>%1: %2, %3 移動しました</translation>
    </message>
</context>
<context>
    <name>suffuse::SettingsDialog</name>
    <message>
        <source>Settings</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>System</source>
        <translation>システム</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>テーマ</translation>
    </message>
    <message>
        <source>Colours of the windows</source>
        <translation>ウィンドウの配色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>ダーク</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>ライト</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>キャンバス</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Raster</source>
        <translation>ラスター</translation>
    </message>
    <message>
        <source>All cores</source>
        <translation>すべてのコア</translation>
    </message>
    <message>
        <source>Threads</source>
        <translation>スレッド</translation>
    </message>
    <message>
        <source>Renderer</source>
        <translation>レンダラー</translation>
    </message>
    <message>
        <source>General</source>
        <translation>全般</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>バックアップ</translation>
    </message>
    <message>
        <source>How many earlier versions are kept when a painting is saved: “name.suffuse~” beside it is the last one, “~2” the one before. File ▸ Restore Backup brings one back.</source>
        <translation>保存時に残す以前のバージョンの数。隣にある「name.suffuse~」が直前のもの、「~2」がその前のものです。「ファイル ▸ バックアップから復元」で戻せます。</translation>
    </message>
    <message>
        <source>Language of the program</source>
        <translation>プログラムの言語</translation>
    </message>
    <message>
        <source>How the picture comes to the screen</source>
        <translation>画像を画面に表示する方法</translation>
    </message>
    <message>
        <source>What computes the picture</source>
        <translation>画像の計算に使うもの</translation>
    </message>
    <message>
        <source>Processor threads for drawing</source>
        <translation>描画に使うプロセッサーのスレッド</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>カラー</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>アニメーション</translation>
    </message>
    <message>
        <source>Whether docks glide to their places and carets blink</source>
        <translation>ドックが滑らかに移動するか、カーソルが点滅するか</translation>
    </message>
    <message>
        <source>Reduced</source>
        <translation>控えめ</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>すべて</translation>
    </message>
</context>
<context>
    <name>suffuse::SheetView</name>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
</context>
<context>
    <name>suffuse::ShortcutsDialog</name>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search shortcuts</source>
        <translation>ショートカットを検索</translation>
    </message>
    <message>
        <source>Shows only commands whose name or shortcut holds this text.</source>
        <translation>名前かショートカットにこの文字を含むコマンドだけを表示します。</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>ショートカット</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>コマンド</translation>
    </message>
    <message>
        <source>Choose a command, then press its new shortcut below.</source>
        <translation>コマンドを選び、下で新しいショートカットを押してください。</translation>
    </message>
    <message>
        <source>Press the keys</source>
        <translation>キーを押してください</translation>
    </message>
    <message>
        <source>No shortcut for this command</source>
        <translation>このコマンドのショートカットをなしにします</translation>
    </message>
    <message>
        <source>This command&apos;s own shortcut</source>
        <translation>このコマンドの元のショートカット</translation>
    </message>
    <message>
        <source>%1 belongs to “%2” and “%3”. Give one of them another shortcut.</source>
        <translation>%1 は「%2」と「%3」の両方に割り当てられています。どちらかに別のショートカットを割り当ててください。</translation>
    </message>
    <message>
        <source>Takes the shortcut away from the other command</source>
        <translation>もう一方のコマンドからショートカットを取り上げます</translation>
    </message>
    <message>
        <source>Fixed: no command can have these keys.</source>
        <translation>固定：どのコマンドにも割り当てられないキーです。</translation>
    </message>
    <message>
        <source>%1 is fixed: “%2”. Give “%3” another shortcut.</source>
        <translation>%1 は固定です：「%2」。「%3」に別のショートカットを割り当ててください。</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>なし(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>リセット(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Take Over</source>
        <translation>割り当てを移す(&amp;T)</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>キーボードショートカット</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>場所</translation>
    </message>
    <message>
        <source>Where the shortcut works. What is typed in a dock, without Ctrl or Alt, stays there.</source>
        <translation>ショートカットが働く場所。ドックで入力したものは、Ctrl や Alt がなければ、そのドックで使われます。</translation>
    </message>
</context>
<context>
    <name>suffuse::SizedTool</name>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Diameter of the circle ([ and ] change it)</source>
        <translation>円の直径（[ と ] で変更）</translation>
    </message>
</context>
<context>
    <name>suffuse::SliderField</name>
    <message>
        <source>Double-click: back to the default.</source>
        <translation>ダブルクリック：既定値に戻す。</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1、スライダー</translation>
    </message>
    <message>
        <source>The values differ. The slider multiplies each of them; with Ctrl it makes them one.</source>
        <translation>値が異なります。スライダーはそれぞれの値に掛けます。Ctrl で同じ値にします。</translation>
    </message>
    <message>
        <source>The values differ. The slider adds to each of them; with Ctrl it makes them one.</source>
        <translation>値が異なります。スライダーはそれぞれの値に加えます。Ctrl で同じ値にします。</translation>
    </message>
    <message>
        <source>The values differ. A number makes them one; *1.2 or +2 changes each of them.</source>
        <translation>値が異なります。数値で同じ値にします。*1.2 や +2 でそれぞれを変更します。</translation>
    </message>
</context>
<context>
    <name>suffuse::SoftReach</name>
    <message>
        <source>Reach</source>
        <translation>影響範囲</translation>
    </message>
    <message>
        <source>How far along the stroke a dragged node or curve takes along what lies near; 0: nothing (wheel or [ and ] during the drag, or Alt+drag, change it)</source>
        <translation>ノードや曲線をドラッグしたときに、近くの部分がストロークに沿ってどこまで動くか。0：なし（ドラッグ中のホイールか [ と ]、または Alt+ドラッグで変更）</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>自動</translation>
    </message>
    <message>
        <source>Let the reach follow the view: soft where nodes would crowd, else the node alone</source>
        <translation>影響範囲を表示倍率に合わせます：ノードが密集する所では滑らかに、それ以外ではノードだけ</translation>
    </message>
    <message>
        <source>Let the reach follow the view</source>
        <translation>影響範囲を表示倍率に合わせる</translation>
    </message>
</context>
<context>
    <name>suffuse::StatusLine</name>
    <message>
        <source>Position of the pointer, in what the rulers count</source>
        <translation>ポインターの位置、単位はルーラーと同じ</translation>
    </message>
    <message>
        <source>Zoom, and the angle by which the canvas is turned</source>
        <translation>ズームと、キャンバスの回転角度</translation>
    </message>
    <message>
        <source>What renders the picture</source>
        <translation>画像の描画に使うもの</translation>
    </message>
    <message>
        <source>Time that the last frame took</source>
        <translation>最後のフレームにかかった時間</translation>
    </message>
    <message>
        <source>You paint in the past: what came later covers it.</source>
        <extracomment>instead of what the brush does, while the timeline shows a moment of the past</extracomment>
        <translation>過去の時点で描いています。後に描いたものが上に重なります。</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <extracomment>a position: x, y</extracomment>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>%1 ms, coarse</source>
        <translation>%1 ms、粗い</translation>
    </message>
    <message>
        <source>Arrow keys move the pen, with Shift far and with Alt finely; Space presses it down and lifts it; + and - change its pressure; Esc puts it away.</source>
        <translation>矢印キーでペンを移動（Shift で大きく、Alt で細かく）。Space で押し下げ・離す。+ と - で筆圧を変更。Esc で終了。</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeHistoryList</name>
    <message>
        <source>History of the selected stroke</source>
        <translation>選択したストロークの履歴</translation>
    </message>
    <message>
        <source>What was done to the selected stroke. Click a state to put this stroke back to it; everything else stays as it is.</source>
        <translation>選択したストロークに行った操作。状態をクリックすると、このストロークだけがその状態に戻り、ほかは変わりません。</translation>
    </message>
    <message>
        <source>As it was at first</source>
        <translation>最初の状態</translation>
    </message>
    <message>
        <source>Put stroke back</source>
        <translation>ストロークの状態を戻す</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokeSection</name>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Name of the selected strokes, as the list of strokes shows it.</source>
        <translation>選択したストロークの名前。ストロークの一覧に表示されます。</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>ストローク名を変更</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混色</translation>
    </message>
    <message>
        <source>How the paint mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>絵の具が下のものとどう混ざるか。覆うか、顔料として加算されます。</translation>
    </message>
    <message>
        <source>Change pigment mixing</source>
        <translation>顔料の混色を変更</translation>
    </message>
    <message>
        <source>Change mixing</source>
        <translation>混色を変更</translation>
    </message>
    <message>
        <source>unnamed</source>
        <translation>名前なし</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>選択したものすべてには設定できません。範囲外になる値があります。</translation>
    </message>
    <message>
        <source>The mixing of the wash is seen in place of this one.</source>
        <translation>これの代わりに、ウォッシュの混色が表示されています。</translation>
    </message>
</context>
<context>
    <name>suffuse::WashRows</name>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>How the density of all strokes of the wash becomes coverage.</source>
        <translation>ウォッシュのすべてのストロークの濃度から被覆率への変わり方。</translation>
    </message>
    <message>
        <source>Mixing</source>
        <translation>混色</translation>
    </message>
    <message>
        <source>How the wash mixes with what lies below it: it covers, or pigments add up.</source>
        <translation>ウォッシュが下のものとどう混ざるか。覆うか、顔料として加算されます。</translation>
    </message>
    <message>
        <source>Change wash</source>
        <translation>ウォッシュを変更</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>選択したものすべてには設定できません：%1</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesModel</name>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ロック</translation>
    </message>
    <message>
        <source>Visible. Click: hide.</source>
        <translation>表示中。クリック：隠す。</translation>
    </message>
    <message>
        <source>Hidden. Click: show.</source>
        <translation>非表示。クリック：表示。</translation>
    </message>
    <message>
        <source>Locked. Click: unlock.</source>
        <translation>ロック中。クリック：ロックを解除。</translation>
    </message>
    <message>
        <source>Not locked. Click: lock.</source>
        <translation>ロックなし。クリック：ロック。</translation>
    </message>
    <message>
        <source>Stroke %1</source>
        <translation>ストローク %1</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>セグメント %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>グループ %1</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>グループ名を変更</translation>
    </message>
    <message>
        <source>Rename stroke</source>
        <translation>ストローク名を変更</translation>
    </message>
    <message>
        <source>Hide group</source>
        <translation>グループを隠す</translation>
    </message>
    <message>
        <source>Show group</source>
        <translation>グループを表示</translation>
    </message>
    <message>
        <source>Unlock group</source>
        <translation>グループのロックを解除</translation>
    </message>
    <message>
        <source>Lock group</source>
        <translation>グループをロック</translation>
    </message>
    <message>
        <source>Hide stroke</source>
        <translation>ストロークを隠す</translation>
    </message>
    <message>
        <source>Show stroke</source>
        <translation>ストロークを表示</translation>
    </message>
    <message>
        <source>Unlock stroke</source>
        <translation>ストロークのロックを解除</translation>
    </message>
    <message>
        <source>Lock stroke</source>
        <translation>ストロークをロック</translation>
    </message>
    <message>
        <source>Reorder strokes</source>
        <translation>ストロークを並べ替え</translation>
    </message>
    <message>
        <source>Segment %1</source>
        <translation>セグメント %1</translation>
    </message>
    <message>
        <source>All in it is hidden. Click: show it.</source>
        <translation>中身はすべて非表示です。クリック：表示。</translation>
    </message>
    <message>
        <source>Some of it is hidden. Click: hide the group.</source>
        <translation>一部が非表示です。クリック：グループを隠す。</translation>
    </message>
    <message>
        <source>All in it is locked. Click: unlock it.</source>
        <translation>中身はすべてロックされています。クリック：ロックを解除。</translation>
    </message>
    <message>
        <source>Some of it is locked. Click: lock the group.</source>
        <translation>一部がロックされています。クリック：グループをロック。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln piece(s)</source>
        <translation>
            <numerusform>部分 %Ln 個</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln erasure(s)</source>
        <translation>
            <numerusform>消し跡 %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <extracomment>between &quot;3 pieces&quot; and &quot;12 erasures&quot;</extracomment>
        <translation>、</translation>
    </message>
    <message>
        <source>mixes by itself</source>
        <translation>単独で混色</translation>
    </message>
    <message>
        <source>%1, painted on</source>
        <translation>%1、描画先</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesPanel</name>
    <message>
        <source>Search</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Search strokes</source>
        <translation>ストロークを検索</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>The topmost stroke comes first. Drag to reorder, double-click to rename; a right click offers more.</source>
        <translation>一番上のストロークが先頭です。ドラッグで並べ替え、ダブルクリックで名前を変更。右クリックでほかの操作。</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>名前を変更(&amp;R)</translation>
    </message>
    <message>
        <source>Mo&amp;ve Up</source>
        <translation>上へ移動(&amp;V)</translation>
    </message>
    <message>
        <source>Move Do&amp;wn</source>
        <translation>下へ移動(&amp;W)</translation>
    </message>
    <message>
        <source>Select rows to move them.</source>
        <translation>移動する行を選択してください。</translation>
    </message>
    <message>
        <source>Nothing changes: this is on top already.</source>
        <translation>何も変わりません。すでに一番上です。</translation>
    </message>
    <message>
        <source>Nothing changes: this is at the bottom already.</source>
        <translation>何も変わりません。すでに一番下です。</translation>
    </message>
    <message>
        <source>Nothing changes: locked strokes stay in place.</source>
        <translation>何も変わりません。ロックされたストロークは移動しません。</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Select &amp;Same</source>
        <translation>同じものを選択(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>色(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Style</source>
        <translation>スタイル(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>ブラシ(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>隠す(&amp;H)</translation>
    </message>
    <message>
        <source>Sh&amp;ow</source>
        <translation>表示(&amp;O)</translation>
    </message>
    <message>
        <source>Un&amp;lock</source>
        <translation>ロックを解除(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>ロック(&amp;L)</translation>
    </message>
    <message>
        <source>Hide strokes</source>
        <translation>ストロークを隠す</translation>
    </message>
    <message>
        <source>Show strokes</source>
        <translation>ストロークを表示</translation>
    </message>
    <message>
        <source>Unlock strokes</source>
        <translation>ストロークのロックを解除</translation>
    </message>
    <message>
        <source>Lock strokes</source>
        <translation>ストロークをロック</translation>
    </message>
    <message>
        <source>Shows only strokes and groups whose name holds this text. Return selects them.</source>
        <translation>名前にこの文字を含むストロークとグループだけを表示します。Enter で選択します。</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名前(&amp;N)</translation>
    </message>
    <message>
        <source>No stroke is called “%1”.</source>
        <translation>「%1」という名前のストロークはありません。</translation>
    </message>
    <message>
        <source>While the list is searched, rows are not dragged: between those that show there may be others. Clear the search first.</source>
        <translation>一覧の検索中は、行をドラッグできません。表示中の行の間に、ほかの行があるかもしれないためです。先に検索を解除してください。</translation>
    </message>
    <message>
        <source>Mi&amp;x by Itself</source>
        <translation>単独で混色(&amp;X)</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>グループを単独で混色</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>グループを下のものと混色</translation>
    </message>
    <message>
        <source>New layer: %1</source>
        <translation>新規レイヤー：%1</translation>
    </message>
    <message>
        <source>Painting on: %1</source>
        <translation>描画先：%1</translation>
    </message>
    <message>
        <source>The layer comes into the list with the first stroke that is painted.</source>
        <translation>レイヤーは、最初のストロークを描くと一覧に入ります。</translation>
    </message>
    <message>
        <source>What is painted goes into this group. A click beside all rows: on top of all again.</source>
        <translation>描いたものはこのグループに入ります。行のない所をクリックすると、再び全体の一番上に描きます。</translation>
    </message>
    <message>
        <source>Painting on top of all</source>
        <translation>全体の一番上に描画</translation>
    </message>
    <message>
        <source>&amp;Mode</source>
        <translation>合成モード(&amp;M)</translation>
    </message>
    <message>
        <source>O&amp;pacity…</source>
        <translation>不透明度(&amp;P)…</translation>
    </message>
    <message>
        <source>New clipped layer: %1</source>
        <translation>新規クリッピングレイヤー：%1</translation>
    </message>
</context>
<context>
    <name>suffuse::StyleSection</name>
    <message>
        <source>Style</source>
        <translation>スタイル</translation>
    </message>
    <message>
        <source>Belongs to</source>
        <translation>適用先</translation>
    </message>
    <message>
        <source>Whether the segments follow their stroke&apos;s style or have their own.</source>
        <translation>セグメントがストロークのスタイルに従うか、独自のスタイルを持つか。</translation>
    </message>
    <message>
        <source>The stroke</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>These segments</source>
        <translation>これらのセグメント</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>How density becomes coverage.</source>
        <translation>濃度から被覆率への変わり方。</translation>
    </message>
    <message>
        <source>Change style</source>
        <translation>スタイルを変更</translation>
    </message>
    <message>
        <source>Give segments their own style</source>
        <translation>セグメントに独自のスタイルを設定</translation>
    </message>
    <message>
        <source>Follow the stroke&apos;s style</source>
        <translation>ストロークのスタイルに従う</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: %1</source>
        <translation>選択したものすべてには設定できません：%1</translation>
    </message>
    <message>
        <source>The style of the wash is seen in place of this one.</source>
        <translation>これの代わりに、ウォッシュのスタイルが表示されています。</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchGrid</name>
    <message>
        <source>Add swatch</source>
        <translation>スウォッチを追加</translation>
    </message>
    <message>
        <source>Move swatch</source>
        <translation>スウォッチを移動</translation>
    </message>
    <message>
        <source>Rename swatch</source>
        <translation>スウォッチ名を変更</translation>
    </message>
    <message>
        <source>Remove swatch</source>
        <translation>スウォッチを削除</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>名前を変更…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Link swatch</source>
        <translation>スウォッチをリンク</translation>
    </message>
    <message>
        <source>Unlink swatch</source>
        <translation>スウォッチのリンクを解除</translation>
    </message>
    <message>
        <source>linked</source>
        <translation>リンク中</translation>
    </message>
    <message>
        <source>Change the Colour</source>
        <translation>色を変更</translation>
    </message>
    <message>
        <source>Linked to What Is Painted with It</source>
        <translation>この色で描いたものにリンク</translation>
    </message>
    <message>
        <source>Select What Has This Colour</source>
        <translation>この色のものを選択</translation>
    </message>
</context>
<context>
    <name>suffuse::SwatchesSection</name>
    <message>
        <source>Swatches</source>
        <translation>スウォッチ</translation>
    </message>
    <message>
        <source>Add swatch</source>
        <translation>スウォッチを追加</translation>
    </message>
    <message>
        <source>Keeps the current colour with the painting.</source>
        <translation>現在の色を絵に保存します。</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>パレット</translation>
    </message>
    <message>
        <source>GIMP palettes in and out</source>
        <translation>GIMP パレットのインポートとエクスポート</translation>
    </message>
    <message>
        <source>Colours kept with the painting. Click: take it. Drag to move; Delete removes.</source>
        <translation>絵に保存した色。クリック：その色を使う。ドラッグで移動、Delete で削除。</translation>
    </message>
    <message>
        <source>None yet: + keeps the current colour.</source>
        <translation>まだありません。+ で現在の色を保存します。</translation>
    </message>
    <message>
        <source>GIMP palettes</source>
        <translation>GIMP パレット</translation>
    </message>
    <message>
        <source>Import palette</source>
        <translation>パレットをインポート</translation>
    </message>
    <message>
        <source>Export palette</source>
        <translation>パレットをエクスポート</translation>
    </message>
    <message>
        <source>Remove all swatches</source>
        <translation>すべてのスウォッチを削除</translation>
    </message>
    <message>
        <source>%1 cannot be read: %2.</source>
        <translation>%1 を読み込めません：%2。</translation>
    </message>
    <message>
        <source>Map Colours to Swatches</source>
        <translation>色をスウォッチに置き換え</translation>
    </message>
    <message>
        <source>Gives what is selected, or else all of the painting, the swatch that looks nearest</source>
        <translation>選択したもの、または絵全体の色を、最も近く見えるスウォッチにします</translation>
    </message>
    <message>
        <source>Import Palette…</source>
        <translation>パレットをインポート…</translation>
    </message>
    <message>
        <source>Export Palette…</source>
        <translation>パレットをエクスポート…</translation>
    </message>
    <message>
        <source>Remove All</source>
        <translation>すべて削除</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelapseDialog</name>
    <message>
        <source>The ending chooses the format: webm or mp4 is a video, webp an animation, and png, tiff, exr, jpg or pfm numbered pictures, such as frame%04d.png.</source>
        <translation>形式は拡張子で決まります。webm と mp4 はビデオ、webp はアニメーション、png、tiff、exr、jpg、pfm は番号付きの画像（例：frame%04d.png）です。</translation>
    </message>
    <message>
        <source>Frame rate</source>
        <translation>フレームレート</translation>
    </message>
    <message>
        <source> frames/s</source>
        <translation> fps</translation>
    </message>
    <message>
        <source>How many pictures a second the film has</source>
        <translation>動画の 1 秒あたりの画像の数</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>How long the film is; the painting&apos;s time is stretched over it.</source>
        <translation>動画の長さ。絵の時間をこの長さに伸縮します。</translation>
    </message>
    <message>
        <source>Animated WebP: begins anew at its end. Players decide it for videos.</source>
        <translation>アニメーション WebP：終わると最初から繰り返します。ビデオではプレーヤーの設定に従います。</translation>
    </message>
    <message>
        <source>Films</source>
        <translation>動画</translation>
    </message>
    <message>
        <source>Numbered pictures</source>
        <translation>番号付きの画像</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 フレーム</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>A film of %1 frames is too long. Choose a lower rate or a shorter length.</source>
        <translation>%1 フレームの動画は長すぎます。フレームレートを下げるか、長さを短くしてください。</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>フレーム %1 / %2</translation>
    </message>
    <message>
        <source>Writing the film…</source>
        <translation>動画を書き込み中…</translation>
    </message>
    <message numerus="yes">
        <source>%1; %n second(s) left</source>
        <translation>
            <numerusform>%1、残り %n 秒</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1; %n minute(s) left</source>
        <translation>
            <numerusform>%1、残り %n 分</numerusform>
        </translation>
    </message>
    <message>
        <source>Longest pause</source>
        <translation>最長の休止</translation>
    </message>
    <message>
        <source>Pauses in which nothing is painted or spreads are cut to this, in the painting&apos;s time.</source>
        <translation>何も描かれず広がりもしない休止を、この長さに縮めます（絵の時間で）。</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>ループ</translation>
    </message>
    <message>
        <source>Export Timelapse</source>
        <translation>タイムラプスをエクスポート</translation>
    </message>
    <message>
        <source>“%1” has no ending of a film or a picture. Choose one of: %2.</source>
        <translation>「%1」に動画または画像の拡張子がありません。次のいずれかを選んでください：%2。</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePanel</name>
    <message>
        <source>%1 is out of range: 0.1 to 1000 times is possible.</source>
        <translation>%1 は範囲外です。0.1～1000 倍を指定できます。</translation>
    </message>
    <message>
        <source>The moment that is shown, and the end, when all has dried</source>
        <translation>表示中の時点と、すべてが乾く終わりの時点</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>How fast the painting is played: 0.1 to 1000 times as fast as it was painted</source>
        <translation>絵の再生速度。描いたときの 0.1～1000 倍</translation>
    </message>
    <message>
        <source>Show all of the time (0). Ctrl+wheel zooms.</source>
        <translation>全時間を表示（0）。Ctrl+ホイールでズーム。</translation>
    </message>
    <message>
        <source>Show all of the time</source>
        <translation>全時間を表示</translation>
    </message>
    <message>
        <source>Go to Its &amp;Start</source>
        <translation>開始へ移動(&amp;S)</translation>
    </message>
    <message>
        <source>Go to When It Is Dr&amp;y</source>
        <translation>乾く時点へ移動(&amp;Y)</translation>
    </message>
    <message>
        <source>Drawing Pa&amp;ce</source>
        <translation>描くペース(&amp;C)</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelinePointer</name>
    <message>
        <source>Stroke %1</source>
        <translation>ストローク %1</translation>
    </message>
    <message>
        <source>Drawn from %1 to %2</source>
        <translation>%1～%2 に描画</translation>
    </message>
    <message>
        <source>Dry at %1</source>
        <translation>%1 に乾燥</translation>
    </message>
    <message>
        <source>Erased in part from %1 on</source>
        <translation>%1 から一部を消去</translation>
    </message>
    <message>
        <source>Wetted again, dry at %1</source>
        <translation>濡らし直し、%1 に乾燥</translation>
    </message>
    <message>
        <source>Locked</source>
        <translation>ロック中</translation>
    </message>
</context>
<context>
    <name>suffuse::TimelineView</name>
    <message>
        <source>Timeline</source>
        <translation>タイムライン</translation>
    </message>
    <message>
        <source>A bar for each stroke, from when it was painted until it is dry.</source>
        <translation>ストロークごとのバー。描かれてから乾くまでの時間です。</translation>
    </message>
</context>
<context>
    <name>suffuse::TransformBar</name>
    <message>
        <source>X</source>
        <extracomment>left edge of the selection</extracomment>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the selected strokes&apos; curves</source>
        <translation>選択したストロークの曲線の左端</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the selected strokes&apos; curves</source>
        <translation>選択したストロークの曲線の上端</translation>
    </message>
    <message>
        <source>W</source>
        <extracomment>width</extracomment>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width of the selected strokes&apos; curves</source>
        <translation>選択したストロークの曲線の幅</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>幅と高さの比を保ちます</translation>
    </message>
    <message>
        <source>Keep the proportions</source>
        <translation>縦横比を固定</translation>
    </message>
    <message>
        <source>H</source>
        <extracomment>height</extracomment>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height of the selected strokes&apos; curves</source>
        <translation>選択したストロークの曲線の高さ</translation>
    </message>
    <message>
        <source>∠</source>
        <translation>∠</translation>
    </message>
    <message>
        <source>Rotate the selected strokes by this angle</source>
        <translation>選択したストロークをこの角度だけ回転します</translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>移動</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>拡大縮小</translation>
    </message>
    <message>
        <source>Some of these strokes would become too small, too large or too far away to be painted.</source>
        <translation>一部のストロークが、小さすぎるか、大きすぎるか、遠すぎて描けなくなります。</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlayLoader</name>
    <message>
        <source>Underlay</source>
        <translation>下絵</translation>
    </message>
</context>
<context>
    <name>suffuse::UnderlaySection</name>
    <message>
        <source>Add…</source>
        <translation>追加…</translation>
    </message>
    <message>
        <source>A picture to paint over. It shows on the canvas only, never in what is exported.</source>
        <translation>上から描くための画像。キャンバスにだけ表示され、エクスポートには含まれません。</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Show the underlay</source>
        <translation>下絵を表示</translation>
    </message>
    <message>
        <source>Take the underlay out of the painting</source>
        <translation>絵から下絵を取り除きます</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly the underlay shows.</source>
        <translation>下絵の表示の濃さ。</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Left edge of the underlay</source>
        <translation>下絵の左端</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Upper edge of the underlay</source>
        <translation>下絵の上端</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>Width of the underlay</source>
        <translation>下絵の幅</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>高さ</translation>
    </message>
    <message>
        <source>Height of the underlay</source>
        <translation>下絵の高さ</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>Keep the proportions of width and height</source>
        <translation>幅と高さの比を保ちます</translation>
    </message>
    <message>
        <source>Fit to Canvas</source>
        <translation>キャンバスに合わせる</translation>
    </message>
    <message>
        <source>In the middle of the canvas, as large as it goes</source>
        <translation>キャンバスの中央に、できるだけ大きく</translation>
    </message>
    <message>
        <source>Replace…</source>
        <translation>置き換え…</translation>
    </message>
    <message>
        <source>Another picture in its place</source>
        <translation>別の画像に置き換えます</translation>
    </message>
    <message>
        <source>Import underlay</source>
        <translation>下絵をインポート</translation>
    </message>
</context>
<context>
    <name>suffuse::ValueCard</name>
    <message>
        <source>Width</source>
        <translation>幅</translation>
    </message>
    <message>
        <source>From one visible edge of the paint to the other, at its widest, as it is now</source>
        <translation>今の状態で、絵の具の見える縁から縁までの、最も広い所の幅</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>値</translation>
    </message>
    <message>
        <source>Whole</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>All that is selected</source>
        <translation>選択したものすべて</translation>
    </message>
    <message>
        <source>Segment</source>
        <translation>セグメント</translation>
    </message>
    <message>
        <source>The segment under the pointer alone</source>
        <translation>ポインターの下のセグメントだけ</translation>
    </message>
    <message>
        <source>Change width</source>
        <translation>幅を変更</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
    <message>
        <source>%1, segment %2</source>
        <translation>%1、セグメント %2</translation>
    </message>
</context>
<context>
    <name>suffuse::ShapeTool</name>
    <message>
        <source>Drag from the middle to a corner. Shift: steps of 15°. Return: as the last one.</source>
        <translation>中心から頂点へドラッグ。Shift：15° 刻み。Enter：前回と同じ。</translation>
    </message>
    <message>
        <source>Drag from corner to corner. Shift: even sides. Ctrl: from the middle. Return: as the last one.</source>
        <translation>角から角へドラッグ。Shift：辺を等しく。Ctrl：中心から。Enter：前回と同じ。</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>長方形</translation>
    </message>
    <message>
        <source>Ellipse</source>
        <translation>楕円</translation>
    </message>
    <message>
        <source>Polygon</source>
        <translation>多角形</translation>
    </message>
    <message>
        <source>Star</source>
        <translation>星形</translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation>描くもの</translation>
    </message>
    <message>
        <source>Corner radius</source>
        <translation>角の半径</translation>
    </message>
    <message>
        <source>Corners</source>
        <translation>頂点</translation>
    </message>
    <message>
        <source>Radius of the corners; half of the shorter side is the most</source>
        <translation>角の半径。最大は短い辺の半分です</translation>
    </message>
    <message>
        <source>How many corners a polygon, or tips a star has</source>
        <translation>多角形の角、または星形の先端の数</translation>
    </message>
    <message>
        <source>Inner</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>Radius of the inner corners, as a share of that of the tips</source>
        <translation>内側の頂点の半径（先端の半径に対する割合）</translation>
    </message>
    <message>
        <source>Round</source>
        <translation>丸み</translation>
    </message>
    <message>
        <source>How much of each side is round</source>
        <translation>各辺のうち丸くなる割合</translation>
    </message>
    <message>
        <source>From</source>
        <translation>開始</translation>
    </message>
    <message>
        <source>Where the arc begins, clockwise from the right</source>
        <translation>弧の始まる角度、右から時計回り</translation>
    </message>
    <message>
        <source>Arc</source>
        <translation>弧</translation>
    </message>
    <message>
        <source>How far the arc goes round; 360° is the whole ellipse</source>
        <translation>弧の角度。360° で楕円全体になります</translation>
    </message>
    <message>
        <source>Pie</source>
        <translation>扇形</translation>
    </message>
    <message>
        <source>An arc is closed through the middle; else by a straight line</source>
        <translation>弧を中心を通って閉じます。オフの場合、直線で閉じます</translation>
    </message>
</context>
<context>
    <name>suffuse::FillSection</name>
    <message>
        <source>How fast the fill spreads: the spread grows with the root of D times time. 0 keeps its edge crisp at any zoom.</source>
        <translation>塗りが広がる速さ。広がりは D×時間の平方根に比例します。0 では、どのズームでも縁がくっきりします。</translation>
    </message>
    <message>
        <source>Density ρ</source>
        <translation>濃度 ρ</translation>
    </message>
    <message>
        <source>Density ρ deep within the fill. On its outline it is half of that, so that with 1 and a threshold of ½ the paint ends there.</source>
        <translation>塗りの十分内側の濃度 ρ。アウトライン上ではその半分になり、1 としきい値 ½ なら、絵の具はそこで終わります。</translation>
    </message>
    <message>
        <source>Fill</source>
        <translation>塗り</translation>
    </message>
    <message>
        <source>What the stroke encloses was wetted at once, and spreads like its paint</source>
        <translation>ストロークで囲まれた部分を一度に濡らし、ストロークの絵の具と同じように広げます</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>内側</translation>
    </message>
    <message>
        <source>All that is enclosed</source>
        <translation>囲まれた部分すべて</translation>
    </message>
    <message>
        <source>Every other area</source>
        <translation>1 つおきの領域</translation>
    </message>
    <message>
        <source>What is inside where the outline overlaps itself (nonzero and even-odd in SVG)</source>
        <translation>アウトラインが自身と重なる所の内側の決め方（SVG の nonzero と even-odd）</translation>
    </message>
    <message>
        <source>Change fill</source>
        <translation>塗りを変更</translation>
    </message>
    <message>
        <source>Remove fill</source>
        <translation>塗りを削除</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>選択したものすべてには設定できません。範囲外になる値があります。</translation>
    </message>
</context>
<context>
    <name>suffuse::VaryDialog</name>
    <message>
        <source>Vary at Random</source>
        <translation>ランダムに変化</translation>
    </message>
    <message>
        <source>Vary</source>
        <translation>変化の対象</translation>
    </message>
    <message>
        <source>D becomes greater by up to this, or smaller by the same factor</source>
        <translation>D が最大でこの倍率まで大きく、または同じ倍率で小さくなります</translation>
    </message>
    <message>
        <source>φ becomes greater by up to this, or smaller by the same factor</source>
        <translation>φ が最大でこの倍率まで大きく、または同じ倍率で小さくなります</translation>
    </message>
    <message>
        <source>t_max becomes greater by up to this, or smaller by the same factor</source>
        <translation>t_max が最大でこの倍率まで大きく、または同じ倍率で小さくなります</translation>
    </message>
    <message>
        <source>So much more grain, or less</source>
        <translation>紙目の増減の最大値</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Colours turn by up to this angle, either way</source>
        <translation>色が最大でこの角度だけ、どちらかに回転します</translation>
    </message>
    <message>
        <source>Lightness</source>
        <translation>明るさ</translation>
    </message>
    <message>
        <source>Colours get lighter or darker by up to this</source>
        <translation>色が最大でこれだけ明るく、または暗くなります</translation>
    </message>
    <message>
        <source>So much more opaque, or less</source>
        <translation>不透明度の増減の最大値</translation>
    </message>
    <message>
        <source>Roll Again</source>
        <translation>振り直す</translation>
    </message>
    <message>
        <source>Other random values by the same amounts</source>
        <translation>同じ量で、別のランダムな値にします</translation>
    </message>
    <message>
        <source>Each stroke</source>
        <translation>ストロークごと</translation>
    </message>
    <message>
        <source>Each segment</source>
        <translation>セグメントごと</translation>
    </message>
    <message>
        <source>Along each stroke</source>
        <translation>ストロークに沿って</translation>
    </message>
    <message>
        <source>What gets a random value of its own; along a stroke values drift smoothly</source>
        <translation>独自のランダムな値を持つ単位。ストロークに沿う場合、値は滑らかに変わります</translation>
    </message>
    <message>
        <source>Of its own</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>長さ</translation>
    </message>
    <message>
        <source>Over this length along a stroke values become others</source>
        <translation>ストロークに沿ってこの長さで、値が別の値に変わります</translation>
    </message>
</context>
<context>
    <name>suffuse::WishFields</name>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>What is painted onto the segments</source>
        <translation>セグメントに塗り付けるもの</translation>
    </message>
    <message>
        <source>Towards a value, or from the value that each segment has</source>
        <translation>ある値に向けて、または各セグメントの今の値から</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>値</translation>
    </message>
    <message>
        <source>What a segment has when it got all of it</source>
        <translation>最後まで塗り付けたときのセグメントの値</translation>
    </message>
    <message>
        <source>set to</source>
        <translation>この値にする</translation>
    </message>
    <message>
        <source>multiply by</source>
        <translation>掛ける</translation>
    </message>
    <message>
        <source>add</source>
        <translation>加える</translation>
    </message>
    <message>
        <source>the current colour</source>
        <translation>現在の色</translation>
    </message>
</context>
<context>
    <name>suffuse::GradientRows</name>
    <message>
        <source>Gradient</source>
        <translation>グラデーション</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>追加</translation>
    </message>
    <message>
        <source>The fill&apos;s colour fades from left to right. The Segments tool drags the ends.</source>
        <translation>塗りの色が左から右へ変わります。端はセグメントツールでドラッグします。</translation>
    </message>
    <message>
        <source>Add gradient</source>
        <translation>グラデーションを追加</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>入れ替え</translation>
    </message>
    <message>
        <source>The two colours change places</source>
        <translation>2 つの色を入れ替えます</translation>
    </message>
    <message>
        <source>Swap colours of gradient</source>
        <translation>グラデーションの色を入れ替え</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>The fill has its first colour everywhere</source>
        <translation>塗り全体が最初の色になります</translation>
    </message>
    <message>
        <source>Remove gradient</source>
        <translation>グラデーションを削除</translation>
    </message>
    <message>
        <source>The second colour of the gradient</source>
        <translation>グラデーションの 2 番目の色</translation>
    </message>
    <message>
        <source>Change gradient</source>
        <translation>グラデーションを変更</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>選択したものすべてには設定できません。範囲外になる値があります。</translation>
    </message>
</context>
<context>
    <name>ColourPicker</name>
    <message>
        <source>Beside the canvas there is no paint to take a colour from, unless paint beyond the canvas is shown.</source>
        <translation>キャンバスの外には、色を採取できる絵の具がありません。キャンバス外の絵の具を表示すると採取できます。</translation>
    </message>
</context>
<context>
    <name>GradientHandles</name>
    <message>
        <source>Drag an end of the gradient. Ctrl: steps of 15°. Click it, and colours are for it.</source>
        <translation>グラデーションの端をドラッグ。Ctrl：15° 刻み。クリックすると、色の操作の対象になります。</translation>
    </message>
    <message>
        <source>Move gradient</source>
        <translation>グラデーションを移動</translation>
    </message>
</context>
<context>
    <name>suffuse::PenTool</name>
    <message>
        <source>Click: corner. Drag: curve, Alt: one handle alone. First node: close. Return: end. Backspace: one back.</source>
        <translation>クリック：角。ドラッグ：曲線、Alt：片方のハンドルだけ。最初のノード：閉じる。Enter：終了。Backspace：1 つ戻る。</translation>
    </message>
    <message>
        <source>Click or drag to go on with the selected stroke from its end.</source>
        <translation>クリックまたはドラッグで、選択したストロークを端から描き足します。</translation>
    </message>
    <message>
        <source>Click for corners, drag for curves. Shift: steps of 15°. An end of a selected stroke: go on with it.</source>
        <translation>クリックで角、ドラッグで曲線。Shift：15° 刻み。選択したストロークの端から：描き足し。</translation>
    </message>
    <message>
        <source>Extend outline</source>
        <translation>アウトラインを描き足す</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>アウトライン</translation>
    </message>
</context>
<context>
    <name>suffuse::LassoFillTool</name>
    <message>
        <source>Click: straight line. First point, double click or Return: close. Shift: steps of 15°.</source>
        <translation>クリック：直線。最初の点、ダブルクリック、Enter：閉じる。Shift：15° 刻み。</translation>
    </message>
    <message>
        <source>Draw around what is to be filled. Alt at the end, or clicks: straight lines.</source>
        <translation>塗りつぶす部分を囲みます。最後に Alt、またはクリックで直線。</translation>
    </message>
    <message>
        <source>Lasso fill</source>
        <translation>投げ縄塗り</translation>
    </message>
</context>
<context>
    <name>suffuse::BucketTool</name>
    <message>
        <source>Click: fill what the paint around that place bounds, with the brush in hand.</source>
        <translation>クリック：その周りの絵の具で囲まれた部分を、使用中のブラシで塗りつぶします。</translation>
    </message>
    <message>
        <source>Over all strokes</source>
        <translation>すべてのストロークの上</translation>
    </message>
    <message>
        <source>Under all strokes</source>
        <translation>すべてのストロークの下</translation>
    </message>
    <message>
        <source>Where the fill lies</source>
        <translation>塗りを置く位置</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>許容値</translation>
    </message>
    <message>
        <source>By how much colours may differ from that under the pointer</source>
        <translation>ポインターの下の色とどれだけ違ってよいか</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>隙間</translation>
    </message>
    <message>
        <source>Openings of the bounds that are narrower are closed</source>
        <translation>これより狭い境界の隙間は閉じます</translation>
    </message>
    <message>
        <source>Grow by</source>
        <translation>拡張</translation>
    </message>
    <message>
        <source>How far the fill reaches under its bounds</source>
        <translation>塗りが境界の下へどれだけ入るか</translation>
    </message>
    <message>
        <source>Only what lies on the canvas is filled.</source>
        <translation>塗りつぶせるのは、キャンバス上の部分だけです。</translation>
    </message>
    <message>
        <source>There is nothing to fill here.</source>
        <translation>ここには塗りつぶすものがありません。</translation>
    </message>
    <message>
        <source>Bucket fill</source>
        <translation>バケツ塗り</translation>
    </message>
    <message>
        <source>Looking for what the paint bounds there. Esc gives it up.</source>
        <translation>絵の具で囲まれた部分を調べています。Esc で中止します。</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile: nothing was filled.</source>
        <translation>その間に絵が変更されたため、何も塗りつぶされませんでした。</translation>
    </message>
</context>
<context>
    <name>suffuse::TextEntry</name>
    <message>
        <source>Text</source>
        <translation>テキスト</translation>
    </message>
</context>
<context>
    <name>suffuse::TextTool</name>
    <message>
        <source>Something in this text is locked: unlock it to change the text.</source>
        <translation>このテキストの一部がロックされています。変更するには、ロックを解除してください。</translation>
    </message>
    <message>
        <source>The font “%1” is not installed here, so these letters stay as they are. Choose another one above, or type on: new letters are those of a font like it.</source>
        <translation>フォント「%1」がここにインストールされていないため、これらの文字はそのまま残ります。上で別のフォントを選ぶか、続けて入力してください。新しい文字は似たフォントになります。</translation>
    </message>
    <message>
        <source>Type. Return: a new line. Esc or a click elsewhere: done.</source>
        <translation>文字を入力。Enter：改行。Esc または別の場所をクリック：完了。</translation>
    </message>
    <message>
        <source>Click or Return: type a text, or in the text that is there.</source>
        <translation>クリックまたは Enter：テキストを入力、または既存のテキストを編集。</translation>
    </message>
</context>
<context>
    <name>suffuse::TextRow</name>
    <message>
        <source>Font</source>
        <translation>フォント</translation>
    </message>
    <message>
        <source>Font: it is not installed here, and another one stands in</source>
        <translation>フォント：ここにインストールされていないため、別のもので代用しています</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>極細</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>細字</translation>
    </message>
    <message>
        <source>Regular</source>
        <translation>標準</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>中字</translation>
    </message>
    <message>
        <source>Semibold</source>
        <translation>中太</translation>
    </message>
    <message>
        <source>Bold</source>
        <translation>太字</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>極太</translation>
    </message>
    <message>
        <source>How strong the letters are</source>
        <translation>文字の太さ</translation>
    </message>
    <message>
        <source>Italic</source>
        <translation>斜体</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>サイズ</translation>
    </message>
    <message>
        <source>The em of the font</source>
        <translation>フォントの em</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>字間</translation>
    </message>
    <message>
        <source>Room that is added between letters, of the size</source>
        <translation>文字の間に加えるアキ（サイズに対する割合）</translation>
    </message>
    <message>
        <source>Lines</source>
        <translation>行送り</translation>
    </message>
    <message>
        <source>From one line to the next, of the size</source>
        <translation>次の行までの距離（サイズに対する割合）</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>行頭</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>中央</translation>
    </message>
    <message>
        <source>End</source>
        <translation>行末</translation>
    </message>
    <message>
        <source>Where lines lie: they begin at the text&apos;s place, are centred on it, or end there</source>
        <translation>行の揃え方：テキストの位置から始まる、中央に揃う、そこで終わる</translation>
    </message>
    <message>
        <source>Vertical</source>
        <translation>縦書き</translation>
    </message>
    <message>
        <source>Lines run from top to bottom, and follow each other from right to left</source>
        <translation>行が上から下へ進み、右から左へ並びます</translation>
    </message>
    <message>
        <source>On Selected Stroke</source>
        <translation>選択したストローク上に</translation>
    </message>
    <message>
        <source>Set the text along the selected stroke, which it follows from then on</source>
        <translation>選択したストロークに沿ってテキストを配置し、以後そのストロークに追従させます</translation>
    </message>
    <message>
        <source>Straight</source>
        <translation>直線</translation>
    </message>
    <message>
        <source>Take the text off its curve</source>
        <translation>テキストを曲線から外します</translation>
    </message>
</context>
<context>
    <name>suffuse::TextValues</name>
    <message>
        <source>Change text</source>
        <translation>テキストを変更</translation>
    </message>
</context>
<context>
    <name>suffuse::BlendMode</name>
    <message>
        <source>Normal</source>
        <translation>通常</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>乗算</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>スクリーン</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>オーバーレイ</translation>
    </message>
    <message>
        <source>Darken</source>
        <translation>比較（暗）</translation>
    </message>
    <message>
        <source>Lighten</source>
        <translation>比較（明）</translation>
    </message>
    <message>
        <source>Colour Dodge</source>
        <translation>覆い焼きカラー</translation>
    </message>
    <message>
        <source>Colour Burn</source>
        <translation>焼き込みカラー</translation>
    </message>
    <message>
        <source>Hard Light</source>
        <translation>ハードライト</translation>
    </message>
    <message>
        <source>Soft Light</source>
        <translation>ソフトライト</translation>
    </message>
    <message>
        <source>Difference</source>
        <comment>blend mode</comment>
        <translation>差の絶対値</translation>
    </message>
    <message>
        <source>Exclusion</source>
        <comment>blend mode</comment>
        <translation>除外</translation>
    </message>
    <message>
        <source>Hue</source>
        <translation>色相</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>彩度</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>カラー</translation>
    </message>
    <message>
        <source>Luminosity</source>
        <translation>輝度</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>加算</translation>
    </message>
    <message>
        <source>Mask Below</source>
        <translation>下をマスク</translation>
    </message>
    <message>
        <source>Erase Below</source>
        <translation>下を消去</translation>
    </message>
    <message>
        <source>Clip to Below</source>
        <translation>下でクリッピング</translation>
    </message>
    <message>
        <source>The group covers what lies below.</source>
        <translation>グループが下のものを覆います。</translation>
    </message>
    <message>
        <source>Darkens, as glazes and shadows do; white changes nothing.</source>
        <translation>グレーズや影のように暗くします。白では何も変わりません。</translation>
    </message>
    <message>
        <source>Lightens, as lights do that fall on one place; black changes nothing.</source>
        <translation>同じ場所に当たる光のように明るくします。黒では何も変わりません。</translation>
    </message>
    <message>
        <source>Multiplies where it is dark below, and screens where it is light there.</source>
        <translation>下が暗い所では乗算、明るい所ではスクリーンになります。</translation>
    </message>
    <message>
        <source>Of each channel the darker value stays.</source>
        <translation>各チャンネルで暗いほうの値が残ります。</translation>
    </message>
    <message>
        <source>Of each channel the lighter value stays.</source>
        <translation>各チャンネルで明るいほうの値が残ります。</translation>
    </message>
    <message>
        <source>Brightens what lies below, strongly where the group is light.</source>
        <translation>グループが明るい所ほど強く、下のものを明るくします。</translation>
    </message>
    <message>
        <source>Deepens what lies below, strongly where the group is dark.</source>
        <translation>グループが暗い所ほど強く、下のものを濃くします。</translation>
    </message>
    <message>
        <source>Multiplies where the group is dark, and screens where it is light.</source>
        <translation>グループが暗い所では乗算、明るい所ではスクリーンになります。</translation>
    </message>
    <message>
        <source>Darkens or lightens gently, as a diffuse light does.</source>
        <translation>拡散光のように、おだやかに暗く、または明るくします。</translation>
    </message>
    <message>
        <source>How far both are apart; white inverts what lies below.</source>
        <translation>両者の差。白では下のものが反転します。</translation>
    </message>
    <message>
        <source>As Difference, with less contrast.</source>
        <translation>差の絶対値に似ていますが、コントラストが低くなります。</translation>
    </message>
    <message>
        <source>The hue of the group, with saturation and luminosity of what lies below.</source>
        <translation>グループの色相と、下のものの彩度と輝度。</translation>
    </message>
    <message>
        <source>The saturation of the group, with hue and luminosity of what lies below.</source>
        <translation>グループの彩度と、下のものの色相と輝度。</translation>
    </message>
    <message>
        <source>Hue and saturation of the group, with the luminosity of what lies below: for tinting.</source>
        <translation>グループの色相と彩度、下のものの輝度：色付けに。</translation>
    </message>
    <message>
        <source>The luminosity of the group, with hue and saturation of what lies below.</source>
        <translation>グループの輝度と、下のものの色相と彩度。</translation>
    </message>
    <message>
        <source>The sum of both, for glows (plus, linear dodge).</source>
        <translation>両者の和。光の表現に（plus、覆い焼き（リニア））。</translation>
    </message>
    <message>
        <source>The group is not seen itself: what lies below stays where the group covers, and goes elsewhere (destination-in).</source>
        <translation>グループ自体は見えません。グループが覆う所で下のものが残り、ほかは消えます（destination-in）。</translation>
    </message>
    <message>
        <source>The group is not seen itself: it takes away what lies below where it covers (destination-out).</source>
        <translation>グループ自体は見えません。グループが覆う所で下のものを取り除きます（destination-out）。</translation>
    </message>
    <message>
        <source>The group is seen only where paint lies below it: for shading a shape without leaving it (source-atop).</source>
        <translation>グループは、下に絵の具がある所でだけ見えます。形からはみ出さずに影を付けるのに使います（source-atop）。</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupSection</name>
    <message>
        <source>Group</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>グループ</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>How strongly the group shows. Below 100 % it fades as a whole: strokes that overlap in it do not show through each other.</source>
        <translation>グループの見える濃さ。100 % 未満では全体が薄くなり、グループ内で重なるストロークが互いに透けません。</translation>
    </message>
    <message>
        <source>Change group opacity</source>
        <translation>グループの不透明度を変更</translation>
    </message>
    <message>
        <source>Not possible for all that is selected: a value would be out of range.</source>
        <translation>選択したものすべてには設定できません。範囲外になる値があります。</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>合成モード</translation>
    </message>
    <message>
        <source>Change group mode</source>
        <translation>グループの合成モードを変更</translation>
    </message>
    <message>
        <source>Mix by itself</source>
        <translation>単独で混色</translation>
    </message>
    <message>
        <source>Mix group by itself</source>
        <translation>グループを単独で混色</translation>
    </message>
    <message>
        <source>Mix group with what lies below</source>
        <translation>グループを下のものと混色</translation>
    </message>
    <message>
        <source>How the group&apos;s picture is put on what lies below. Any mode but Normal has its strokes mix by themselves first.</source>
        <translation>グループの画像を下のものに重ねる方法。「通常」以外では、先にストロークが単独で混色されます。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <extracomment>the mode that is chosen, and what it does</extracomment>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>The group&apos;s strokes mix among themselves, and their picture is put on what lies below. Otherwise they mix with what lies below as if there were no group.</source>
        <translation>グループのストロークを互いに混色し、その画像を下のものに重ねます。オフの場合、グループがないかのように下のものと混色されます。</translation>
    </message>
    <message>
        <source>Clip to below</source>
        <translation>下でクリッピング</translation>
    </message>
    <message>
        <source>Mask</source>
        <translation>マスク</translation>
    </message>
    <message>
        <source>Wash</source>
        <translation>ウォッシュ</translation>
    </message>
    <message>
        <source>The group is seen only where the next thing below it in the same group is: for shading a shape without leaving it.</source>
        <translation>グループは、同じグループ内ですぐ下にあるものの範囲でだけ見えます。形からはみ出さずに影を付けるのに使います。</translation>
    </message>
    <message>
        <source>The group is not seen itself; what else is in the same group is seen only where it has paint.</source>
        <translation>グループ自体は見えません。同じグループ内のほかのものが、このグループに絵の具がある所でだけ見えます。</translation>
    </message>
    <message>
        <source>All strokes of the group are one, laid wet into wet: their densities add up, with one style and one mixing. Filled strokes, hidden ones and those of a mask within it stay by themselves.</source>
        <translation>グループのすべてのストロークを、ウェットインウェットで一体にします。濃度が足し合わされ、スタイルと混色は 1 つになります。塗りのあるもの、非表示のもの、中のマスクのストロークは別のままです。</translation>
    </message>
    <message>
        <source>There is nothing below it to clip to.</source>
        <translation>下に、クリッピングの基準になるものがありません。</translation>
    </message>
    <message>
        <source>There is nothing beside it to mask.</source>
        <translation>同じ階層にほかのものがないため、マスクできません。</translation>
    </message>
    <message>
        <source>It is in a wash already.</source>
        <translation>すでにウォッシュの中にあります。</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>ラベル</translation>
    </message>
    <message>
        <source>A colour that marks the group for you, in lists. It is not seen in the picture.</source>
        <translation>一覧でグループを見分けるための色。絵には現れません。</translation>
    </message>
    <message>
        <source>Mark group</source>
        <translation>グループにラベルを付ける</translation>
    </message>
    <message>
        <source>The group mixes by itself in any case: by its opacity or its mode, or since it is clipped or a mask.</source>
        <translation>このグループは、不透明度か合成モード、またはクリッピングかマスクのため、常に単独で混色されます。</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>下描き</translation>
    </message>
    <message>
        <source>The group is seen here, and left out of pictures and films that are exported: for sketches and pictures to paint over.</source>
        <translation>グループはここでは見え、エクスポートした画像や動画には含まれません。スケッチや、上から描くための画像に使います。</translation>
    </message>
</context>
<context>
    <name>suffuse::GroupTag</name>
    <message>
        <source>None</source>
        <comment>mark of a group</comment>
        <translation>なし</translation>
    </message>
    <message>
        <source>Red</source>
        <comment>mark of a group</comment>
        <translation>赤</translation>
    </message>
    <message>
        <source>Orange</source>
        <comment>mark of a group</comment>
        <translation>オレンジ</translation>
    </message>
    <message>
        <source>Yellow</source>
        <comment>mark of a group</comment>
        <translation>黄</translation>
    </message>
    <message>
        <source>Green</source>
        <comment>mark of a group</comment>
        <translation>緑</translation>
    </message>
    <message>
        <source>Blue</source>
        <comment>mark of a group</comment>
        <translation>青</translation>
    </message>
    <message>
        <source>Violet</source>
        <comment>mark of a group</comment>
        <translation>紫</translation>
    </message>
    <message>
        <source>Brown</source>
        <comment>mark of a group</comment>
        <translation>茶</translation>
    </message>
    <message>
        <source>Grey</source>
        <comment>mark of a group</comment>
        <translation>グレー</translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>%1: the linked picture is missing or has changed. Put it back, or link it anew in the Inspector.</source>
        <translation>%1: リンクされた画像がないか、変更されています。元に戻すか、インスペクターでリンクし直してください。</translation>
    </message>
    <message>
        <source>the image of a picture is missing</source>
        <translation>画像がありません</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>画像</translation>
    </message>
</context>
<context>
    <name>LayeredFile</name>
    <message>
        <source>%1: Photoshop files have at most 2 GB. Choose a smaller size, or OpenRaster.</source>
        <translation>%1: Photoshop ファイルは最大 2 GB です。より小さいサイズか、OpenRaster を選んでください。</translation>
    </message>
    <message>
        <source>%1: Photoshop files have at most %2 pixels a side. Choose a smaller size, or OpenRaster.</source>
        <translation>%1: Photoshop ファイルの一辺は最大 %2 ピクセルです。より小さいサイズか、OpenRaster を選んでください。</translation>
    </message>
    <message>
        <source>Background</source>
        <translation>背景</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>グループ %1</translation>
    </message>
    <message>
        <source>stopped; nothing was written</source>
        <translation>中止しました。何も書き込まれていません</translation>
    </message>
    <message>
        <source>The file could not be packed.</source>
        <translation>ファイルを圧縮できませんでした。</translation>
    </message>
</context>
<context>
    <name>ImageLayer</name>
    <message>
        <source>%1: the pictures of a painting may have %2 million pixels together, and this one would be too many. Scale it down, or remove another one.</source>
        <translation>%1: 絵に入れられる画像は合計 %2 百万ピクセルまでで、これを加えると超えてしまいます。縮小するか、別の画像を削除してください。</translation>
    </message>
    <message>
        <source>Import picture</source>
        <translation>画像をインポート</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>The picture of the clipboard cannot be read.</source>
        <translation>クリップボードの画像を読み込めません。</translation>
    </message>
    <message>
        <source>Paste picture</source>
        <translation>画像を貼り付け</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>Underlay to layer</source>
        <translation>下絵をレイヤーに変換</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>画像をリンク</translation>
    </message>
    <message>
        <source>Embed picture</source>
        <translation>画像を埋め込み</translation>
    </message>
    <message>
        <source>Reset proportions</source>
        <translation>縦横比をリセット</translation>
    </message>
</context>
<context>
    <name>suffuse::PictureSection</name>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Linked to a file</source>
        <translation>ファイルにリンク</translation>
    </message>
    <message>
        <source>The painting names the picture&apos;s file, and does not hold the picture itself. Otherwise the picture is in the painting, whatever becomes of the file.</source>
        <translation>絵は画像のファイル名だけを持ち、画像自体は含みません。オフの場合、画像は絵に含まれ、ファイルがどうなっても残ります。</translation>
    </message>
    <message>
        <source>Relink…</source>
        <translation>リンクし直す…</translation>
    </message>
    <message>
        <source>Another file, or the same one where it lies now, in the picture&apos;s place</source>
        <translation>画像を、別のファイル、または移動した同じファイルに置き換えます</translation>
    </message>
    <message>
        <source>Reset Proportions</source>
        <translation>縦横比をリセット</translation>
    </message>
    <message>
        <source>As high and wide as its pixels ask for: its top left corner, its direction and its width stay.</source>
        <translation>ピクセルの縦横比に戻します。左上の角、向き、幅は変わりません。</translation>
    </message>
    <message>
        <source>Link picture</source>
        <translation>画像をリンク</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 ピクセル</translation>
    </message>
    <message numerus="yes">
        <source>%n picture(s)</source>
        <translation>
            <numerusform>画像 %n 枚</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 is missing or has changed, and is not seen.</source>
        <translation>%1 がないか変更されているため、表示されません。</translation>
    </message>
    <message>
        <source>A picture is missing, and is not seen.</source>
        <translation>画像がないため、表示されません。</translation>
    </message>
</context>
<context>
    <name>Drawing</name>
    <message>
        <source>interrupted</source>
        <translation>中断しました</translation>
    </message>
    <message>
        <source>interrupted; nothing was written</source>
        <translation>中断しました。何も書き込まれていません</translation>
    </message>
    <message>
        <source>the sheet is too large for a picture with a pixel a unit</source>
        <translation>用紙が、1 単位 1 ピクセルの画像には大きすぎます</translation>
    </message>
    <message numerus="yes">
        <source>SVG has no groups that erase what lies below: %n group(s) became plain.</source>
        <translation>
            <numerusform>SVG には下のものを消去するグループがありません。%n 個のグループが通常のグループになりました。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n stroke(s) are left out, since nothing of them is covered enough to have a path.</source>
        <translation>
            <numerusform>ストローク %n 本は、パスにできるほど覆う部分がないため、省かれました。</numerusform>
        </translation>
    </message>
    <message>
        <source>The drawing differs from the picture by at most %1 of 255, by %2 on average.</source>
        <translation>ベクター画像と絵の差は、255 段階中最大 %1、平均 %2 です。</translation>
    </message>
    <message>
        <source>%1: would have %2 MB once it is unpacked, and could not be opened again. Choose fewer bands, or the ending .svg.</source>
        <translation>%1: 展開すると %2 MB になり、再び開けなくなります。帯を減らすか、拡張子を .svg にしてください。</translation>
    </message>
    <message numerus="yes">
        <source>PDF has no groups that erase what lies below, or add to it: %n group(s) became plain.</source>
        <translation>
            <numerusform>PDF には下のものを消去または加算するグループがありません。%n 個のグループが通常のグループになりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>アウトライン</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingDialog</name>
    <message>
        <source>One path for each stroke, where it is covered by half: for plotters, cutters, logos.</source>
        <translation>ストロークごとに 1 つのパス。半分まで覆う所を囲みます。プロッター、カッター、ロゴ用。</translation>
    </message>
    <message>
        <source>Contours within each other, as opaque as the paint. They look like the painting at any zoom.</source>
        <translation>入れ子の等高線に、絵の具の不透明度を付けたもの。どのズームでも絵と同じように見えます。</translation>
    </message>
    <message>
        <source>The exact picture, a pixel a unit, and over it the outlines without paint, to select and name strokes by.</source>
        <translation>1 単位 1 ピクセルの正確な画像の上に、絵の具のないアウトラインを重ねたもの。ストロークを選択し、名前で見分けられます。</translation>
    </message>
    <message>
        <source>Export Drawing</source>
        <translation>ベクター画像をエクスポート</translation>
    </message>
    <message>
        <source>The ending chooses the format: svg, svgz, which is packed, or pdf.</source>
        <translation>形式は拡張子で決まります：svg、svgz（圧縮）、pdf。</translation>
    </message>
    <message>
        <source>Bands</source>
        <translation>帯</translation>
    </message>
    <message>
        <source>Outlines</source>
        <translation>アウトライン</translation>
    </message>
    <message>
        <source>Picture and outlines</source>
        <translation>画像とアウトライン</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>What of the painting becomes paths</source>
        <translation>絵のどの部分をパスにするか</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>段階</translation>
    </message>
    <message>
        <source>How many bands full opacity is drawn in. More of them are smoother, and make a larger file.</source>
        <translation>不透明度 100 % までを分ける帯の数。多いほど滑らかで、ファイルが大きくなります。</translation>
    </message>
    <message>
        <source>Of red, green and blue, over the sheet, with a pixel a unit</source>
        <translation>赤、緑、青の、用紙全体での差。1 単位 1 ピクセル</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>差</translation>
    </message>
    <message>
        <source>Comparing with the picture…</source>
        <translation>画像と比較中…</translation>
    </message>
    <message>
        <source>It is exported as soon as it is compared with the picture.</source>
        <translation>画像との比較が終わりしだい書き出します。</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>不明</translation>
    </message>
    <message>
        <source>Drawings</source>
        <translation>ベクター画像</translation>
    </message>
    <message>
        <source>“%1” has no ending of a drawing. Choose one of: %2.</source>
        <translation>「%1」にベクター画像の拡張子がありません。次のいずれかを選んでください：%2。</translation>
    </message>
    <message>
        <source>As large as the sheet</source>
        <translation>用紙と同じ大きさ</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>ページ</translation>
    </message>
    <message>
        <source>Of a PDF: the sheet fits into the page, in its middle. By itself it is as large as on paper or, where that is not said, has 96 units an inch.</source>
        <translation>PDF の場合：用紙がページの中央に収まります。用紙の大きさは印刷サイズで、指定がなければ 1 インチあたり 96 単位です。</translation>
    </message>
</context>
<context>
    <name>suffuse::DrawingJob</name>
    <message>
        <source>The drawing does not fit into memory.</source>
        <translation>ベクター画像がメモリに収まりません。</translation>
    </message>
</context>
<context>
    <name>suffuse::StrokesView</name>
    <message numerus="yes">
        <source>%Ln row(s)</source>
        <translation>
            <numerusform>%Ln 行</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ColourProfile</name>
    <message>
        <source>it is no ICC profile of RGB, grey or CMYK</source>
        <translation>RGB、グレースケール、CMYK の ICC プロファイルではありません</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is too large</source>
        <translation>%1: 読み込めないか、大きすぎます</translation>
    </message>
</context>
<context>
    <name>suffuse::Proofing</name>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>ソフトプルーフのプロファイル</translation>
    </message>
    <message>
        <source>Colours not converted</source>
        <translation>色は変換されていません</translation>
    </message>
    <message>
        <source>Proof: %1</source>
        <translation>プルーフ：%1</translation>
    </message>
</context>
<context>
    <name>ChooseProfile</name>
    <message>
        <source>Colour profiles</source>
        <translation>カラープロファイル</translation>
    </message>
</context>
<context>
    <name>suffuse::ColourPage</name>
    <message>
        <source>That of the system</source>
        <translation>システムのプロファイル</translation>
    </message>
    <message>
        <source>None (sRGB)</source>
        <translation>なし（sRGB）</translation>
    </message>
    <message>
        <source>From a file</source>
        <translation>ファイルから</translation>
    </message>
    <message>
        <source>Screen profile</source>
        <translation>モニタープロファイル</translation>
    </message>
    <message>
        <source>What the screen makes of its numbers. The canvas is converted to it, so that colours look as they were meant.</source>
        <translation>モニターが数値をどう表示するか。色が意図どおりに見えるよう、キャンバスをこれに合わせて変換します。</translation>
    </message>
    <message>
        <source>Screen profile file</source>
        <translation>モニタープロファイルのファイル</translation>
    </message>
    <message>
        <source>Chooses the ICC profile that was measured for this screen</source>
        <translation>このモニターを測定した ICC プロファイルを選びます</translation>
    </message>
    <message>
        <source>Soft proof</source>
        <translation>ソフトプルーフ</translation>
    </message>
    <message>
        <source>Chooses the ICC profile of a press or a printer. View ▸ Soft Proof shows the colours that are left there.</source>
        <translation>印刷機やプリンターの ICC プロファイルを選びます。「表示 ▸ ソフトプルーフ」で、再現される色を表示します。</translation>
    </message>
    <message>
        <source>Perceptual</source>
        <translation>知覚的</translation>
    </message>
    <message>
        <source>Relative colorimetric</source>
        <translation>相対的な色域を維持</translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation>彩度</translation>
    </message>
    <message>
        <source>Absolute colorimetric</source>
        <translation>絶対的な色域を維持</translation>
    </message>
    <message>
        <source>Rendering intent</source>
        <translation>マッチング方法</translation>
    </message>
    <message>
        <source>What becomes of colours that the device of the soft proof does not have</source>
        <translation>ソフトプルーフの機器で再現できない色の扱い</translation>
    </message>
    <message>
        <source>Black point compensation</source>
        <translation>黒点の補正</translation>
    </message>
    <message>
        <source>The darkest colour becomes the darkest one that the device has</source>
        <translation>最も暗い色を、機器の最も暗い色に合わせます</translation>
    </message>
    <message>
        <source>Profile of the Screen</source>
        <translation>モニターのプロファイル</translation>
    </message>
    <message>
        <source>Profile of the Soft Proof</source>
        <translation>ソフトプルーフのプロファイル</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選択…</translation>
    </message>
</context>
<context>
    <name>suffuse::ProfileBox</name>
    <message>
        <source>The painting&apos;s profile</source>
        <translation>絵のプロファイル</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>ファイルから…</translation>
    </message>
    <message>
        <source>%1: the profile is too large to be kept in a painting. Choose a smaller one.</source>
        <translation>%1: プロファイルが大きすぎて絵に保存できません。より小さいものを選んでください。</translation>
    </message>
    <message>
        <source>%1: %2. Choose a profile of RGB colours.</source>
        <translation>%1: %2。RGB カラーのプロファイルを選んでください。</translation>
    </message>
    <message>
        <source>Profile of the Colours</source>
        <translation>カラーのプロファイル</translation>
    </message>
</context>
<context>
    <name>suffuse::FitJob</name>
    <message>
        <source>%1: there is not enough memory to fit it.</source>
        <translation>%1: 近似するにはメモリが足りません。</translation>
    </message>
</context>
<context>
    <name>FitLayer</name>
    <message>
        <source>Ground</source>
        <translation>下地</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>Picture to strokes</source>
        <translation>画像をストロークに変換</translation>
    </message>
    <message>
        <source>The picture was painted quickly, just before the moment that you look at. All that you painted stays as it is.</source>
        <translation>画像は、表示中の時点の直前に短時間で描かれたものとして入りました。これまでに描いたものは変わりません。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) came in, and a ground below them.</source>
        <translation>
            <numerusform>ストローク %Ln 本と、その下の下地が入りました。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::FitView</name>
    <message>
        <source>Picture made of strokes</source>
        <translation>ストロークで作った画像</translation>
    </message>
    <message>
        <source>What the strokes look like. While a mouse button is held on it, the original is seen.</source>
        <translation>ストロークの見た目。マウスボタンを押している間、元の画像を表示します。</translation>
    </message>
    <message>
        <source>Here the picture grows, stroke by stroke.</source>
        <translation>ここに、ストロークが 1 本ずつ加わって画像ができていきます。</translation>
    </message>
</context>
<context>
    <name>suffuse::FitRows</name>
    <message>
        <source>Strokes</source>
        <translation>ストローク</translation>
    </message>
    <message>
        <source>At most so many. More of them go on with those that are there; fewer begin anew.</source>
        <translation>ストローク数の上限。増やすと今のものに続け、減らすと最初からやり直します。</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>精密さ</translation>
    </message>
    <message>
        <source>How much is done for each stroke. Better goes on with what is there.</source>
        <translation>ストローク 1 本にかける手間。上げると今のものに続けます。</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>高速</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>高品質</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最高品質</translation>
    </message>
    <message>
        <source>Style</source>
        <translation>スタイル</translation>
    </message>
    <message>
        <source>Of all strokes. Another one begins anew.</source>
        <translation>すべてのストロークに共通です。変えると最初からやり直します。</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Each stroke its own, or a few paints, which become linked swatches</source>
        <translation>ストロークごとに別の色、または少数の絵の具（リンクされたスウォッチになります）</translation>
    </message>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Few paints</source>
        <translation>少数</translation>
    </message>
    <message>
        <source>Paints</source>
        <translation>絵の具の数</translation>
    </message>
    <message>
        <source>So many colours in all</source>
        <translation>全体で使う色の数</translation>
    </message>
    <message>
        <source>More</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Widths of strokes, and the roll of the dice</source>
        <translation>ストロークの幅と、乱数</translation>
    </message>
    <message>
        <source>Least width</source>
        <translation>最小幅</translation>
    </message>
    <message>
        <source>No stroke is narrower; 0: as narrow as it likes</source>
        <translation>これより細いストロークは作りません。0：制限なし</translation>
    </message>
    <message>
        <source>Greatest width</source>
        <translation>最大幅</translation>
    </message>
    <message>
        <source>No stroke is wider; 0: as wide as it likes</source>
        <translation>これより太いストロークは作りません。0：制限なし</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>シード</translation>
    </message>
    <message>
        <source>Another number gives other strokes, equally good ones</source>
        <translation>別の数にすると、同じくらい良い別のストロークになります</translation>
    </message>
    <message>
        <source>The greatest width is below the least one.</source>
        <translation>最大幅が最小幅より小さくなっています。</translation>
    </message>
</context>
<context>
    <name>suffuse::FitDialog</name>
    <message>
        <source>far: %1 dB</source>
        <translation>差が大きい：%1 dB</translation>
    </message>
    <message>
        <source>roughly: %1 dB</source>
        <translation>おおよそ近い：%1 dB</translation>
    </message>
    <message>
        <source>near: %1 dB</source>
        <translation>近い：%1 dB</translation>
    </message>
    <message>
        <source>very near: %1 dB</source>
        <translation>とても近い：%1 dB</translation>
    </message>
    <message>
        <source>Picture to Strokes</source>
        <translation>画像をストロークに変換</translation>
    </message>
    <message>
        <source>How far it is</source>
        <translation>進み具合</translation>
    </message>
    <message>
        <source>Original</source>
        <translation>元の画像</translation>
    </message>
    <message>
        <source>Shows the picture itself: while held, or click to switch back and forth.</source>
        <translation>元の画像を表示します。押している間、またはクリックで切り替え。</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>Which picture becomes strokes</source>
        <translation>ストロークにする画像</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>Underlay</source>
        <translation>下絵</translation>
    </message>
    <message>
        <source>File…</source>
        <translation>ファイル…</translation>
    </message>
    <message>
        <source>&amp;Insert</source>
        <translation>挿入(&amp;I)</translation>
    </message>
    <message>
        <source>Puts the strokes so far into the painting, as a layer</source>
        <translation>ここまでのストロークを、レイヤーとして絵に入れます</translation>
    </message>
    <message>
        <source>Go On</source>
        <translation>続ける</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops the work, or goes on with it</source>
        <translation>作業を停止、または続けます</translation>
    </message>
    <message>
        <source>Reading the picture…</source>
        <translation>画像を読み込み中…</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
    <message>
        <source>off by %1 of 255</source>
        <translation>差 %1 / 255</translation>
    </message>
    <message>
        <source>Fewer Strokes</source>
        <translation>ストロークを減らす</translation>
    </message>
    <message>
        <source>What the strokes are to look like: as those that are there do, or as a picture of the whole sheet</source>
        <translation>ストロークが目指す見た目：今の見た目、または用紙全体の画像</translation>
    </message>
    <message>
        <source>As they look</source>
        <translation>今の見た目</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>置き換え(&amp;R)</translation>
    </message>
    <message>
        <source>Puts the strokes so far in place of the selected ones</source>
        <translation>選択したストロークを、ここまでのストロークに置き換えます</translation>
    </message>
    <message>
        <source>Give up the strokes so far?</source>
        <translation>ここまでのストロークを破棄しますか？</translation>
    </message>
    <message>
        <source>Replace puts them in place of the selected ones.</source>
        <translation>「置き換え」で、選択したストロークと置き換わります。</translation>
    </message>
    <message>
        <source>Insert puts them into the painting.</source>
        <translation>「挿入」で、絵に入ります。</translation>
    </message>
    <message>
        <source>&amp;Give Up</source>
        <translation>破棄(&amp;G)</translation>
    </message>
</context>
<context>
    <name>fitting</name>
    <message>
        <source>stopped</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>%1: is black all over, so nothing counts; paint white what is to be fitted</source>
        <translation>%1: 全体が黒で、考慮する部分がありません。近似する部分を白く塗ってください</translation>
    </message>
    <message>
        <source>its canvas has %1 × %2 units, and the picture %3 × %4 pixels; go on with a painting that was fitted to this picture</source>
        <translation>キャンバスは %1 × %2 単位、画像は %3 × %4 ピクセルです。この画像から近似した絵で続けてください</translation>
    </message>
    <message>
        <source>stroke %1: %2; a fit goes on with what a fit made</source>
        <translation>ストローク %1: %2。近似を続けられるのは、近似で作ったものだけです</translation>
    </message>
</context>
<context>
    <name>curves</name>
    <message>
        <source>its picture has %1 × %2 pixels; image_width and image_height must be 1 at least</source>
        <translation>画像が %1 × %2 ピクセルです。image_width と image_height は 1 以上でなければなりません</translation>
    </message>
    <message>
        <source>holds no curves; there is nothing to solve</source>
        <translation>曲線がありません。解くものがありません</translation>
    </message>
</context>
<context>
    <name>refit</name>
    <message>
        <source>none of the strokes is visible and unlocked; choose others</source>
        <translation>表示されていてロックされていないストロークがありません。ほかのストロークを選んでください</translation>
    </message>
    <message>
        <source>the strokes lie beside the sheet, where nothing is seen of them</source>
        <translation>ストロークが用紙の外にあり、見えません</translation>
    </message>
    <message>
        <source>the strokes of group “%1” mix in their own way; choose all of them that are visible, or none of them</source>
        <translation>グループ「%1」のストロークは独自に混色されます。表示中のものをすべて選ぶか、1 つも選ばないでください</translation>
    </message>
    <message>
        <source>group “%1” is a wash, whose strokes are one; make it a group like others first</source>
        <translation>グループ「%1」はウォッシュで、ストロークが一体になっています。先に通常のグループにしてください</translation>
    </message>
    <message>
        <source>%1: has the shape %2 × %3, and the sheet %4 × %5; crop it to the shape of the sheet</source>
        <translation>%1: 縦横比が %2 × %3 で、用紙は %4 × %5 です。用紙の縦横比に合わせて切り抜いてください</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>中止しました</translation>
    </message>
    <message>
        <source>the strokes are in a group that is put on the others as one picture, so no picture of the whole says how they should look; make it a group like others first</source>
        <translation>ストロークが、1 つの画像としてほかに重ねられるグループの中にあるため、全体の画像からは個々の見え方がわかりません。先に通常のグループにしてください</translation>
    </message>
    <message>
        <source>other strokes hide the chosen ones wholly; choose others, or hide what lies above</source>
        <translation>選んだストロークが、ほかのストロークに完全に隠れています。別のものを選ぶか、上にあるものを隠してください</translation>
    </message>
</context>
<context>
    <name>RefitTask</name>
    <message>
        <source>There the picture is off by %1 of 255 (root mean square), %2 at most.</source>
        <translation>そこでの画像の差は、255 段階中 %1（二乗平均平方根）、最大 %2 です。</translation>
    </message>
    <message>
        <source>Fewer strokes</source>
        <translation>ストロークを減らす</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in place of %Ln.</source>
        <translation>
            <numerusform>（元は %Ln 本）。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s) that lay between them lie below now.</source>
        <translation>
            <numerusform>間にあった %Ln 本のストロークは下に移りました。</numerusform>
        </translation>
    </message>
    <message>
        <source>That is farther than before, when it was off by %1; Undo brings the former strokes back.</source>
        <translation>元の差 %1 より大きくなりました。「元に戻す」で元のストロークに戻せます。</translation>
    </message>
</context>
<context>
    <name>Tiles</name>
    <message>
        <source>%1 What another backend draws has other bits, and is not mixed in. Start again to go on.</source>
        <translation>%1 別のバックエンドの描画は結果が一致しないため、混在させません。続けるには、開始し直してください。</translation>
    </message>
    <message>
        <source>there is not enough memory for the sheets that are drawn at once</source>
        <translation>シートを一度に描画するにはメモリが足りません</translation>
    </message>
    <message>
        <source>a tile cannot be encoded: %1</source>
        <translation>タイルをエンコードできません: %1</translation>
    </message>
    <message>
        <source>%1: cannot be read (%2)</source>
        <translation>%1: 読み込めません（%2）</translation>
    </message>
    <message>
        <source>%1: what is there is of another picture, or of another build or backend. Remove it, or choose another name.</source>
        <translation>%1: 別の画像、または別のビルドかバックエンドのものがあります。削除するか、別の名前を選んでください。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Choose another folder, or change its permissions.</source>
        <translation>%1: 書き込めません（%2）。別のフォルダーを選ぶか、アクセス権を変更してください。</translation>
    </message>
    <message>
        <source>%1: another program is drawing the same picture. Wait until it has finished, or choose another name.</source>
        <translation>%1: 別のプログラムが同じ画像を描画中です。終わるまで待つか、別の名前を選んでください。</translation>
    </message>
</context>
<context>
    <name>suffuse::ManualWindow</name>
    <message>
        <source>Suffuse Manual</source>
        <translation>Suffuse マニュアル</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>マニュアルを検索</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>目次</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>進む</translation>
    </message>
    <message>
        <source>Nothing found</source>
        <translation>見つかりません</translation>
    </message>
</context>
<context>
    <name>suffuse::Lesson</name>
    <message>
        <source>Paint, and change your mind</source>
        <translation>描いて、後から変える</translation>
    </message>
    <message>
        <source>Let paint spread</source>
        <translation>絵の具を広げる</translation>
    </message>
    <message>
        <source>Work with layers</source>
        <translation>レイヤーを使う</translation>
    </message>
    <message>
        <source>Done. All of this can be changed at any time.</source>
        <translation>完了です。これらはすべて、いつでも変更できます。</translation>
    </message>
    <message>
        <source>Press B and draw a stroke on the sheet, however you like.</source>
        <translation>B を押して、用紙に好きなようにストロークを描いてください。</translation>
    </message>
    <message>
        <source>Press V for the Select tool, and click the paint of your stroke.</source>
        <translation>V を押して選択ツールにし、ストロークの絵の具をクリックしてください。</translation>
    </message>
    <message>
        <source>Choose another colour in the Colour dock. It is now about what is selected.</source>
        <translation>色ドックで別の色を選んでください。今は、選択したものの色が対象です。</translation>
    </message>
    <message>
        <source>Take it back with Ctrl+Z.</source>
        <translation>Ctrl+Z で元に戻してください。</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. Watch it spread after you let go.</source>
        <translation>B を押して、ストロークを描いてください。手を離した後に広がる様子を見てください。</translation>
    </message>
    <message>
        <source>Press D: this goes to the moment when everything is dry.</source>
        <translation>D を押してください。すべてが乾く時点に移動します。</translation>
    </message>
    <message>
        <source>In the Inspector dock, drag the slider of Diffusion D. The dry paint spreads further, or less far.</source>
        <translation>インスペクタードックで、「拡散 D」のスライダーをドラッグしてください。乾いた絵の具の広がりが、大きくなったり小さくなったりします。</translation>
    </message>
    <message>
        <source>Choose Layer ▸ New Layer, or press Ctrl+Shift+N. What you paint next comes into it.</source>
        <translation>「レイヤー ▸ 新規レイヤー」を選ぶか、Ctrl+Shift+N を押してください。次に描くものがそこに入ります。</translation>
    </message>
    <message>
        <source>Press B and draw a stroke. The layer comes into the list with it.</source>
        <translation>B を押して、ストロークを描いてください。レイヤーが一緒に一覧に入ります。</translation>
    </message>
    <message>
        <source>In the row of the layer, drag its opacity to the left, or click its mode and choose another one.</source>
        <translation>レイヤーの行で、不透明度を左へドラッグするか、合成モードをクリックして別のものを選んでください。</translation>
    </message>
</context>
<context>
    <name>suffuse::LessonCard</name>
    <message>
        <source>%1 – step %2 of %3</source>
        <translation>%1 – ステップ %2 / %3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Leave the lesson</source>
        <translation>レッスンを終える</translation>
    </message>
</context>
<context>
    <name>suffuse::Sheets</name>
    <message>
        <source>Screen</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>%1 × %2 px</source>
        <translation>%1 × %2 px</translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation>%1 × %2 mm</translation>
    </message>
    <message>
        <source>%1 × %2 in</source>
        <translation>%1 × %2 in</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>紙</translation>
    </message>
    <message>
        <source>Templates</source>
        <translation>テンプレート</translation>
    </message>
    <message>
        <source>Sketch</source>
        <translation>スケッチ</translation>
    </message>
    <message>
        <source>Full HD</source>
        <translation>フル HD</translation>
    </message>
    <message>
        <source>4K</source>
        <translation>4K</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>正方形</translation>
    </message>
    <message>
        <source>A5</source>
        <translation>A5</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>A3</source>
        <translation>A3</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>レター</translation>
    </message>
    <message>
        <source>Legal</source>
        <translation>リーガル</translation>
    </message>
    <message>
        <source>Tabloid</source>
        <translation>タブロイド</translation>
    </message>
    <message>
        <source>Postcard</source>
        <translation>はがき</translation>
    </message>
    <message>
        <source>Watercolour sheet</source>
        <translation>水彩紙</translation>
    </message>
    <message>
        <source>Rice paper</source>
        <translation>和紙</translation>
    </message>
    <message>
        <source>Toned paper</source>
        <translation>色付きの紙</translation>
    </message>
    <message>
        <source>Night</source>
        <translation>夜</translation>
    </message>
    <message>
        <source>Canvas</source>
        <translation>キャンバス地</translation>
    </message>
</context>
<context>
    <name>suffuse::WelcomeDialog</name>
    <message>
        <source>Welcome to Suffuse</source>
        <translation>Suffuse へようこそ</translation>
    </message>
    <message>
        <source>New painting</source>
        <translation>新しい絵</translation>
    </message>
    <message>
        <source>Other Size…</source>
        <translation>ほかのサイズ…</translation>
    </message>
    <message>
        <source>Open a painting</source>
        <translation>絵を開く</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>最近使った絵</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>サンプル</translation>
    </message>
    <message>
        <source>Open File…</source>
        <translation>ファイルを開く…</translation>
    </message>
    <message>
        <source>Three short lessons</source>
        <translation>3 つの短いレッスン</translation>
    </message>
    <message>
        <source>Show this at the start</source>
        <translation>起動時に表示</translation>
    </message>
    <message>
        <source>Sheets by their size. Return begins a painting on one.</source>
        <translation>サイズ別の用紙。Enter でその用紙に描き始めます。</translation>
    </message>
    <message>
        <source>Recent paintings and samples. Return opens one.</source>
        <translation>最近使った絵とサンプル。Enter で開きます。</translation>
    </message>
</context>
<context>
    <name>suffuse::Workspaces</name>
    <message>
        <source>Save Workspace</source>
        <translation>ワークスペースを保存</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>There is a workspace “%1” already.</source>
        <translation>ワークスペース「%1」はすでにあります。</translation>
    </message>
    <message>
        <source>It would be replaced by how the window is arranged now.</source>
        <translation>今のウィンドウの配置に置き換わります。</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>置き換え</translation>
    </message>
    <message>
        <source>The workspace “%1” was saved: View ▸ Workspaces.</source>
        <translation>ワークスペース「%1」を保存しました（「表示 ▸ ワークスペース」）。</translation>
    </message>
    <message>
        <source>The workspace “%1” is damaged. Save it anew.</source>
        <translation>ワークスペース「%1」は破損しています。保存し直してください。</translation>
    </message>
    <message>
        <source>&amp;Delete Workspace</source>
        <translation>ワークスペースを削除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the workspace “%1”?</source>
        <translation>ワークスペース「%1」を削除しますか？</translation>
    </message>
    <message>
        <source>The window stays arranged as it is.</source>
        <translation>ウィンドウの配置は今のままです。</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>削除</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferencePanel</name>
    <message>
        <source>Open…</source>
        <translation>開く…</translation>
    </message>
    <message>
        <source>Choose a picture to look at while painting</source>
        <translation>描きながら見る画像を選びます</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>全体</translation>
    </message>
    <message>
        <source>Show all of the picture</source>
        <translation>画像全体を表示します</translation>
    </message>
    <message>
        <source>100 %</source>
        <translation>100 %</translation>
    </message>
    <message>
        <source>A pixel of the picture is one of the screen</source>
        <translation>画像の 1 ピクセルを画面の 1 ピクセルで表示します</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Show no picture here; its file stays</source>
        <translation>ここに画像を表示しません。ファイルは残ります</translation>
    </message>
    <message>
        <source>Open Reference Picture</source>
        <translation>参照画像を開く</translation>
    </message>
    <message>
        <source>Actual pixels</source>
        <translation>実際のピクセル</translation>
    </message>
</context>
<context>
    <name>suffuse::ReferenceView</name>
    <message>
        <source>Reference picture</source>
        <translation>参照画像</translation>
    </message>
    <message>
        <source>Arrow keys move a cross, and Return picks the colour there.</source>
        <translation>矢印キーで十字カーソルを動かし、Enter でその色を採取します。</translation>
    </message>
    <message>
        <source>Drop a picture here to look at it while you paint, and to take colours from it.</source>
        <translation>ここに画像をドロップすると、描きながら見たり、色を採取したりできます。</translation>
    </message>
</context>
<context>
    <name>suffuse::ViewWindow</name>
    <message>
        <source>View of the painting</source>
        <translation>絵のビュー</translation>
    </message>
    <message>
        <source>View</source>
        <translation>ビュー</translation>
    </message>
    <message>
        <source>%1 · view at %2 %</source>
        <translation>%1 · ビュー %2 %</translation>
    </message>
</context>
<context>
    <name>suffuse::Extensions</name>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: install bubblewrap, and they have no network and can write nowhere else.</source>
        <translation>プログラムの時間、メモリ、書き込み量は制限されますが、隔離されていません。bubblewrap をインストールすると、ネットワークを使えず、ほかの場所に書き込めなくなります。</translation>
    </message>
    <message>
        <source>Programs are confined by bubblewrap: they have no network, unless they say that they need it, and can write in a temporary folder only.</source>
        <translation>プログラムは bubblewrap で隔離されています。必要と宣言しない限りネットワークを使えず、書き込めるのは一時フォルダーだけです。</translation>
    </message>
    <message>
        <source>Programs are limited in time, memory and what they write, but not confined: bubblewrap is installed, and does not work here (%1).</source>
        <translation>プログラムの時間、メモリ、書き込み量は制限されますが、隔離されていません。bubblewrap はインストールされていますが、ここでは動作しません（%1）。</translation>
    </message>
    <message>
        <source>it wrote no result</source>
        <translation>結果が書き込まれていません</translation>
    </message>
    <message>
        <source>its result cannot be read</source>
        <translation>結果を読み込めません</translation>
    </message>
    <message>
        <source>its result is no file</source>
        <translation>結果がファイルではありません</translation>
    </message>
    <message>
        <source>its result is too large</source>
        <translation>結果が大きすぎます</translation>
    </message>
    <message>
        <source>its result is empty</source>
        <translation>結果が空です</translation>
    </message>
    <message>
        <source>Nothing that is visible and unlocked is selected. Select strokes first.</source>
        <translation>表示されていてロックされていないものが、選択されていません。先にストロークを選択してください。</translation>
    </message>
    <message>
        <source>Nothing in the layer is visible and unlocked.</source>
        <translation>レイヤーに、表示されていてロックされていないものがありません。</translation>
    </message>
    <message>
        <source>No temporary folder can be made: %1. Set TMPDIR to a folder that can be written.</source>
        <translation>一時フォルダーを作成できません: %1。TMPDIR に書き込み可能なフォルダーを設定してください。</translation>
    </message>
    <message>
        <source>%1: cannot be written (%2). Is the disk full?</source>
        <translation>%1: 書き込めません（%2）。ディスクがいっぱいではありませんか？</translation>
    </message>
    <message>
        <source>The program %1 cannot be started: %2.</source>
        <translation>プログラム %1 を起動できません: %2。</translation>
    </message>
    <message numerus="yes">
        <source>It was ended after %n second(s), which is as long as it may take.</source>
        <translation>
            <numerusform>制限時間の %n 秒を超えたため、終了させました。</numerusform>
        </translation>
    </message>
    <message>
        <source>It was ended, since it took more than %1 MB of memory.</source>
        <translation>%1 MB を超えるメモリを使ったため、終了させました。</translation>
    </message>
    <message>
        <source>It was ended, since it wrote more than %1 MB.</source>
        <translation>%1 MB を超えて書き込んだため、終了させました。</translation>
    </message>
    <message>
        <source>The program was killed or crashed. The painting is as it was.</source>
        <translation>プログラムが強制終了されたか、異常終了しました。絵は元のままです。</translation>
    </message>
    <message>
        <source>The program failed (exit code %1). The painting is as it was.</source>
        <translation>プログラムが失敗しました（終了コード %1）。絵は元のままです。</translation>
    </message>
    <message>
        <source>It wrote: %1</source>
        <translation>出力: %1</translation>
    </message>
    <message>
        <source>Its result is not used, and the painting is as it was: %1.</source>
        <translation>結果は使われず、絵は元のままです: %1。</translation>
    </message>
    <message>
        <source>%1 was not written: %2.</source>
        <translation>%1 は書き込まれませんでした: %2。</translation>
    </message>
    <message>
        <source>a colour is red, yellow, blue and opacity, each from 0 to 1</source>
        <translation>色は赤、黄、青、不透明度で、それぞれ 0～1 です</translation>
    </message>
    <message>
        <source>give a number</source>
        <translation>数値を指定してください</translation>
    </message>
    <message>
        <source>%1 is not in [%2, %3]</source>
        <translation>%1 は [%2, %3] の範囲外です</translation>
    </message>
    <message>
        <source>%1 is no whole number</source>
        <translation>%1 は整数ではありません</translation>
    </message>
    <message>
        <source>“%1” is none of %2</source>
        <translation>「%1」は次のいずれでもありません: %2</translation>
    </message>
    <message>
        <source>give true or false</source>
        <translation>true か false を指定してください</translation>
    </message>
    <message>
        <source>give a text of at most %1 characters</source>
        <translation>%1 文字以内のテキストを指定してください</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>ファイルを選んでください</translation>
    </message>
    <message>
        <source>%1: the name must end with .%2</source>
        <translation>%1: 名前の末尾を .%2 にしてください</translation>
    </message>
    <message>
        <source>%1: there is no such file</source>
        <translation>%1: そのようなファイルはありません</translation>
    </message>
    <message>
        <source>%1: there is no such folder</source>
        <translation>%1: そのようなフォルダーはありません</translation>
    </message>
    <message>
        <source>“%1” is no number</source>
        <translation>「%1」は数値ではありません</translation>
    </message>
    <message>
        <source>“%1” is neither true nor false</source>
        <translation>「%1」は true でも false でもありません</translation>
    </message>
    <message>
        <source>%1: cannot be read, or is larger than 1 MB</source>
        <translation>%1: 読み込めないか、1 MB を超えています</translation>
    </message>
    <message>
        <source>%1: %2 has the id “%3”, too; give it another one</source>
        <translation>%1: %2 も ID「%3」を持っています。別の ID を付けてください</translation>
    </message>
    <message>
        <source>Python 3 is missing. Install python3.</source>
        <translation>Python 3 がありません。python3 をインストールしてください。</translation>
    </message>
    <message>
        <source>The program %1 is missing, or cannot be started. Install it.</source>
        <translation>プログラム %1 がないか、起動できません。インストールしてください。</translation>
    </message>
    <message>
        <source>%1 does not find the Python modules %2. Install them by packages such as python3-suffuse and python3-numpy, or by pip as docs/python.md says.</source>
        <translation>%1 が Python モジュール %2 を見つけられません。python3-suffuse や python3-numpy のようなパッケージで、または docs/python.md のとおりに pip でインストールしてください。</translation>
    </message>
    <message>
        <source>name the program, and what it is started with</source>
        <translation>プログラムと、それを起動するものを指定してください</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>ありません</translation>
    </message>
    <message>
        <source>“%1” is not “%2”</source>
        <translation>「%1」は「%2」ではありません</translation>
    </message>
    <message>
        <source>version %1 is not known; this program reads version %2</source>
        <translation>バージョン %1 は不明です。このプログラムが読み込めるのはバージョン %2 です</translation>
    </message>
    <message>
        <source>“%1” does not look like %2</source>
        <translation>「%1」が %2 の形になっていません</translation>
    </message>
    <message>
        <source>a text has 1 to 2000 characters</source>
        <translation>テキストは 1～2000 文字です</translation>
    </message>
    <message>
        <source>give a text, or one for each language</source>
        <translation>テキストを 1 つ、または言語ごとに 1 つ指定してください</translation>
    </message>
    <message>
        <source>give at most %1 texts of 1 to 4096 characters</source>
        <translation>1～4096 文字のテキストを最大 %1 個指定してください</translation>
    </message>
    <message>
        <source>there are at most 3 submenus within each other</source>
        <translation>サブメニューの入れ子は最大 3 段です</translation>
    </message>
    <message>
        <source>there are at most %1 fields</source>
        <translation>フィールドは最大 %1 個です</translation>
    </message>
    <message>
        <source>two fields are called %1</source>
        <translation>%1 という名前のフィールドが 2 つあります</translation>
    </message>
    <message>
        <source>the field&apos;s type must stand before its default</source>
        <translation>フィールドの type は default より前に書いてください</translation>
    </message>
    <message>
        <source>there are at most %1 choices</source>
        <translation>選択肢は最大 %1 個です</translation>
    </message>
    <message>
        <source>is not above least</source>
        <translation>least より大きくありません</translation>
    </message>
    <message>
        <source>whole numbers are from -1000000000 to 1000000000</source>
        <translation>整数は -1000000000～1000000000 です</translation>
    </message>
    <message>
        <source>“%1” is no ending; give it without its dot</source>
        <translation>「%1」は拡張子ではありません。先頭のドットなしで指定してください</translation>
    </message>
    <message>
        <source>a part of the painting was passed, so canvas, palette and underlay must stay as they are</source>
        <translation>絵の一部だけが渡されたため、キャンバス、パレット、下絵は変更できません</translation>
    </message>
    <message>
        <source>It was stopped.</source>
        <translation>停止されました。</translation>
    </message>
    <message>
        <source>It went well.</source>
        <translation>正常に終了しました。</translation>
    </message>
    <message>
        <source>The result does not fit into memory.</source>
        <translation>結果がメモリに収まりません。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionDialog</name>
    <message>
        <source>Progress</source>
        <translation>進行状況</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>実行(&amp;R)</translation>
    </message>
    <message>
        <source>%1 exists. Replace it?</source>
        <translation>%1 はすでにあります。置き換えますか？</translation>
    </message>
    <message>
        <source>What it holds now is lost.</source>
        <translation>今の内容は失われます。</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>置き換え(&amp;R)</translation>
    </message>
    <message>
        <source>It was stopped. The painting is as it was.</source>
        <translation>停止されました。絵は元のままです。</translation>
    </message>
    <message>
        <source>The painting has changed meanwhile, so the result is not used. Run it again.</source>
        <translation>その間に絵が変更されたため、結果は使われません。もう一度実行してください。</translation>
    </message>
</context>
<context>
    <name>suffuse::ExtensionFields</name>
    <message>
        <source>&amp;Browse…</source>
        <translation>参照(&amp;B)…</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>フォルダーと名前を選択</translation>
    </message>
</context>
<context>
    <name>suffuse::ManageExtensionsDialog</name>
    <message>
        <source>Manage Extensions</source>
        <translation>拡張機能を管理</translation>
    </message>
    <message>
        <source>Extensions</source>
        <translation>拡張機能</translation>
    </message>
    <message>
        <source>Extension</source>
        <translation>拡張機能</translation>
    </message>
    <message>
        <source>From</source>
        <translation>提供元</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状態</translation>
    </message>
    <message>
        <source>About the extension</source>
        <translation>拡張機能について</translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation>フォルダーを開く(&amp;O)</translation>
    </message>
    <message>
        <source>Your own extensions lie there, each in a folder with a manifest</source>
        <translation>自分の拡張機能はここに、それぞれマニフェスト付きのフォルダーで置きます</translation>
    </message>
    <message>
        <source>Read &amp;Again</source>
        <translation>読み直す(&amp;A)</translation>
    </message>
    <message>
        <source>Looks for extensions anew, after files were changed</source>
        <translation>ファイルの変更後に、拡張機能を探し直します</translation>
    </message>
    <message>
        <source>You</source>
        <translation>自分</translation>
    </message>
    <message>
        <source>Suffuse</source>
        <translation>Suffuse</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>使用できません</translation>
    </message>
    <message>
        <source>There are no extensions yet. Put a folder with a manifest into yours.</source>
        <translation>拡張機能はまだありません。自分のフォルダーに、マニフェスト付きのフォルダーを入れてください。</translation>
    </message>
    <message>
        <source>It uses the network.</source>
        <translation>ネットワークを使います。</translation>
    </message>
    <message>
        <source>The last run: %1</source>
        <translation>前回の実行：%1</translation>
    </message>
    <message>
        <source>Your extensions lie in %1.</source>
        <translation>自分の拡張機能は %1 にあります。</translation>
    </message>
    <message>
        <source>What the chosen extension does, what is wrong with it, and what it wrote when it last ran</source>
        <translation>選んだ拡張機能の働き、問題点、前回の実行時の出力</translation>
    </message>
    <message>
        <source>Those that are checked stand in the menu</source>
        <translation>チェックしたものがメニューに並びます</translation>
    </message>
</context>
<context>
    <name>ColourWords</name>
    <message>
        <source>dark red</source>
        <translation>暗い赤</translation>
    </message>
    <message>
        <source>red</source>
        <translation>赤</translation>
    </message>
    <message>
        <source>light red</source>
        <translation>明るい赤</translation>
    </message>
    <message>
        <source>brown</source>
        <translation>茶</translation>
    </message>
    <message>
        <source>orange</source>
        <translation>オレンジ</translation>
    </message>
    <message>
        <source>light orange</source>
        <translation>明るいオレンジ</translation>
    </message>
    <message>
        <source>olive</source>
        <translation>オリーブ</translation>
    </message>
    <message>
        <source>yellow</source>
        <translation>黄</translation>
    </message>
    <message>
        <source>light yellow</source>
        <translation>明るい黄</translation>
    </message>
    <message>
        <source>dark yellow-green</source>
        <translation>暗い黄緑</translation>
    </message>
    <message>
        <source>yellow-green</source>
        <translation>黄緑</translation>
    </message>
    <message>
        <source>light yellow-green</source>
        <translation>明るい黄緑</translation>
    </message>
    <message>
        <source>dark green</source>
        <translation>暗い緑</translation>
    </message>
    <message>
        <source>green</source>
        <translation>緑</translation>
    </message>
    <message>
        <source>light green</source>
        <translation>明るい緑</translation>
    </message>
    <message>
        <source>dark turquoise</source>
        <translation>暗い青緑</translation>
    </message>
    <message>
        <source>turquoise</source>
        <translation>青緑</translation>
    </message>
    <message>
        <source>light turquoise</source>
        <translation>明るい青緑</translation>
    </message>
    <message>
        <source>dark blue</source>
        <translation>暗い青</translation>
    </message>
    <message>
        <source>blue</source>
        <translation>青</translation>
    </message>
    <message>
        <source>light blue</source>
        <translation>明るい青</translation>
    </message>
    <message>
        <source>dark violet</source>
        <translation>暗い紫</translation>
    </message>
    <message>
        <source>violet</source>
        <translation>紫</translation>
    </message>
    <message>
        <source>light violet</source>
        <translation>明るい紫</translation>
    </message>
    <message>
        <source>dark magenta</source>
        <translation>暗いマゼンタ</translation>
    </message>
    <message>
        <source>magenta</source>
        <translation>マゼンタ</translation>
    </message>
    <message>
        <source>pink</source>
        <translation>ピンク</translation>
    </message>
    <message>
        <source>black</source>
        <translation>黒</translation>
    </message>
    <message>
        <source>dark grey</source>
        <translation>暗いグレー</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>グレー</translation>
    </message>
    <message>
        <source>light grey</source>
        <translation>明るいグレー</translation>
    </message>
    <message>
        <source>white</source>
        <translation>白</translation>
    </message>
</context>
<context>
    <name>SpokenNames</name>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>More buttons</source>
        <translation>その他のボタン</translation>
    </message>
</context>
<context>
    <name>StrokeWords</name>
    <message>
        <source>stroke %1</source>
        <translation>ストローク %1</translation>
    </message>
    <message>
        <source>even</source>
        <translation>均一</translation>
    </message>
    <message>
        <source>feathered</source>
        <translation>ぼかし</translation>
    </message>
    <message>
        <source>dark edge</source>
        <translation>濃い縁</translation>
    </message>
    <message>
        <source>picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>%1 and other colours</source>
        <translation>%1 とほかの色</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>塗りあり</translation>
    </message>
    <message numerus="yes">
        <source>%Ln segment(s)</source>
        <translation>
            <numerusform>セグメント %Ln 個</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>非表示</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>ロック中</translation>
    </message>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>suffuse::CanvasReading</name>
    <message numerus="yes">
        <source>%Ln stroke(s)</source>
        <translation>
            <numerusform>ストローク %Ln 本</numerusform>
        </translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message numerus="yes">
        <source>%Ln selected</source>
        <translation>
            <numerusform>%Ln 個を選択中</numerusform>
        </translation>
    </message>
    <message>
        <source>Select</source>
        <translation>選択</translation>
    </message>
    <message>
        <source>Selects this and nothing else</source>
        <translation>これだけを選択します</translation>
    </message>
    <message>
        <source>Adds this to the selection, or takes it away</source>
        <translation>これを選択に追加、または除外します</translation>
    </message>
</context>
<context>
    <name>suffuse::PenSpeech</name>
    <message>
        <source>Arrow keys move the pen, Space presses it down and lifts it. Esc puts it away.</source>
        <translation>矢印キーでペンを移動、Space で押し下げ・離す。Esc で終了。</translation>
    </message>
    <message>
        <source>The pen is put away.</source>
        <translation>ペンを終了しました。</translation>
    </message>
    <message>
        <source>Pen down at %1.</source>
        <translation>%1 でペンを下ろしました。</translation>
    </message>
    <message>
        <source>Pen up at %1.</source>
        <translation>%1 でペンを上げました。</translation>
    </message>
    <message>
        <source>Pen up at %1: %2.</source>
        <translation>%1 でペンを上げました：%2。</translation>
    </message>
    <message>
        <source>Given up.</source>
        <translation>中止しました。</translation>
    </message>
    <message>
        <source>Pressure %1 %</source>
        <translation>筆圧 %1 %</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>suffuse::Samples</name>
    <message>
        <source>Harbour</source>
        <translation>港</translation>
    </message>
    <message>
        <source>Ink Landscape</source>
        <translation>水墨の風景</translation>
    </message>
    <message>
        <source>Lanterns</source>
        <translation>灯籠</translation>
    </message>
    <message>
        <source>Moonrise</source>
        <translation>月の出</translation>
    </message>
    <message>
        <source>Sheet of Strokes</source>
        <translation>ストローク見本</translation>
    </message>
    <message>
        <source>Still Life</source>
        <translation>静物</translation>
    </message>
</context>
</TS>
