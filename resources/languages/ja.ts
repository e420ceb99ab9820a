<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
 <context>
  <name>procc</name>
  <message>
   <source>the principal point is far from the centre of the picture, which seems cut out of a larger one</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>主点が画像の中心から離れており、より大きな画像から切り出されたようです</translation>
  </message>
  <message>
   <source>with aspect ratio and principal point {px} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>アスペクト比と主点を加えて {px} px：明らかな改善なし</translation>
  </message>
  <message>
   <source>coordinates look like pixels, expected 0 to 1 (x = {x:g}, y = {y:g})</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>座標がピクセルのようです。0～1 が必要です（x = {x:g}、y = {y:g}）</translation>
  </message>
  <message>
   <source>without lens distortion the points are {without} px off, with it {with_it} px: not clearly better</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>レンズ歪みなしで点のずれ {without} px、ありで {with_it} px：明らかな改善なし</translation>
  </message>
  <message>
   <source>aspect ratio and principal point bring the points from {before} to {after} px, more than three parameters would by chance</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>アスペクト比と主点で点のずれが {before} から {after} px に減り、3 個のパラメーターの偶然を超えます</translation>
  </message>
  <message>
   <source>lens distortion brings the points from {before} to {after} px</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>レンズ歪みで点のずれが {before} から {after} px に減ります</translation>
  </message>
  <message>
   <source>the points show lens distortion clearly and are {px} px off</source>
   <extracomment>[procc_annotator/calibration/fitting.py]</extracomment>
   <translation>点は明らかなレンズ歪みを示し、ずれは {px} px です</translation>
  </message>
  <message>
   <source>even with the position known: {why}</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>位置が分かっていても：{why}</translation>
  </message>
  <message>
   <source>{count} positions, and nothing tells which is its</source>
   <extracomment>[procc_annotator/calibration/joint/shared_position.py]</extracomment>
   <translation>位置が {count} 個あり、どれのものか分かりません</translation>
  </message>
  <message>
   <source>all labels fit with far and near exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>奥と手前を入れ替えると、すべてのクラスが合います</translation>
  </message>
  <message>
   <source>all labels fit with left and right exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>左と右を入れ替えると、すべてのクラスが合います</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, {before:.1f} px as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>要素のずれは平均 {after:.1f} px、今のままでは {before:.1f} px</translation>
  </message>
  <message>
   <source>two points are exchanged: the one of {some} and the one of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>2 つの点が入れ替わっています：{some} の点と {others} の点</translation>
  </message>
  <message>
   <source>elements are {after:.1f} px off on average, no camera fits the labels as they are</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>要素のずれは平均 {after:.1f} px、今のクラスのままではどのカメラも合いません</translation>
  </message>
  <message>
   <source>{a} and {b} fit with each other's label</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} と {b} は、互いのクラスに替えると合います</translation>
  </message>
  <message>
   <source>{titles} fit with each other's labels</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{titles} は、互いのクラスに替えると合います</translation>
  </message>
  <message>
   <source>relabel {steps}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>クラスを変更：{steps}</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} は、ほかの要素から求めたカメラの示す位置から最大 {px:.0f} px ずれています</translation>
  </message>
  <message>
   <source>{title} is nowhere near where the camera of the others shows it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} は、ほかの要素から求めたカメラの示す位置から大きく外れています</translation>
  </message>
  <message>
   <source>without {titles} the others drop from {before:.1f} to {after:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{titles} を除くと、残りのずれは {before:.1f} px から {after:.1f} px に下がります</translation>
  </message>
  <message>
   <source>swap {a} and {b}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{a} と {b} を入れ替える</translation>
  </message>
  <message>
   <source>{a} to {b}</source>
   <comment>labels</comment>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{a} → {b}</translation>
  </message>
  <message>
   <source>it lies where {title} should be</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} があるはずの場所にあります</translation>
  </message>
  <message>
   <source>the others are {px:.1f} px off with and without it</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>残りのずれは、あってもなくても {px:.1f} px です</translation>
  </message>
  <message>
   <source>more than its own place is uncertain</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>要素自体の位置の不確かさを超えています</translation>
  </message>
  <message>
   <source>relabel to {title}</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py, procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>クラスを {title} に変更</translation>
  </message>
  <message>
   <source>it lies on {title}, which is annotated as well</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} の上にあり、それも注釈済みです</translation>
  </message>
  <message>
   <source>{title} is up to {px:.0f} px from where the camera shows it; too few elements fit to say which are wrong</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>{title} は、カメラの示す位置から最大 {px:.0f} px ずれています。合う要素が少なく、どれが誤りか判断できません</translation>
  </message>
  <message>
   <source>no camera fits these labels together</source>
   <extracomment>[procc_annotator/calibration/label_check/camera_rules.py]</extracomment>
   <translation>これらのクラスすべてに合うカメラがありません</translation>
  </message>
  <message>
   <source>exchange far and near in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>フレーム全体で奥と手前を入れ替える</translation>
  </message>
  <message>
   <source>exchange left and right in the whole frame</source>
   <extracomment>[procc_annotator/calibration/label_check/candidate_classes.py]</extracomment>
   <translation>フレーム全体で左と右を入れ替える</translation>
  </message>
  <message>
   <source>turn the labels by half a turn</source>
   <extracomment>[procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>クラスを半回転させる</translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn</source>
   <extracomment>the camera stands on a side of the field where hardly any other of {n} frame does: a camera of its own, or labels turned by half a turn / the camera stands on a side of the field where hardly any other of {n} frames does: a camera of its own, or labels turned by half a turn [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>カメラが、ほかの {n} フレームではほとんど見られない側にあります。別のカメラか、クラスが半回転しています</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does</source>
   <extracomment>the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frame does / the camera stands on the other side of the field from the rest; with its labels turned by half a turn it stands where that of {n} frames does [procc_annotator/calibration/label_check/check.py]</extracomment>
   <translation>
    <numerusform>カメラが、ほかのフレームとは反対の側にあります。クラスを半回転させると {n} フレームのカメラと同じ側になります</numerusform>
   </translation>
  </message>
  <message>
   <source>no such class: {name!r}, did you mean {title}?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{name!r} というクラスはありません。{title} のことですか？</translation>
  </message>
  <message>
   <source>{title} is straight on the field, its points lie up to {px:.0f} px beside a line, more than any lens bends it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} はフィールド上では直線ですが、点が直線から最大 {px:.0f} px 外れています。どのレンズの曲がりよりも大きい値です</translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points, a line takes two</source>
   <extracomment>{title} has {n} point, a line takes two / {title} has {n} points, a line takes two [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} の点は {n} 個です。線には 2 個必要です</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points; a curve takes at least {least}</source>
   <extracomment>{title} has {n} point; a curve takes at least {least} / {title} has {n} points; a curve takes at least {least} [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} の点は {n} 個です。曲線には {least} 個以上必要です</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{title} has {n} points: {least} points needed for a curve</source>
   <extracomment>{title} has {n} point: {least} points needed for a curve / {title} has {n} points: {least} points needed for a curve [procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>
    <numerusform>{title} の点は {n} 個です。曲線には {least} 個必要です</numerusform>
   </translation>
  </message>
  <message>
   <source>{title} is a single place, it has {count} points up to {px:.0f} px apart</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} は 1 か所の点ですが、最大 {px:.0f} px 離れた点が {count} 個あります</translation>
  </message>
  <message>
   <source>the points of {title} go back and forth instead of along it</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} の点が、線に沿わず行きつ戻りつしています</translation>
  </message>
  <message>
   <source>no such class: {name!r} fits no camera, and counts as missed where it is scored</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{name!r} というクラスはありません。どのカメラにも当てはまらず、採点では見逃しとして数えます</translation>
  </message>
  <message>
   <source>{a} and {b} lie on top of each other, less than {px:.0f} px apart: one line under two names?</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{a} と {b} が {px:.0f} px 未満の間隔で重なっています。1 本の線に 2 つの名前ですか？</translation>
  </message>
  <message>
   <source>remove point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>点 {number} を取り除く</translation>
  </message>
  <message>
   <source>look at point {number}</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py, procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>点 {number} を確認する</translation>
  </message>
  <message>
   <source>the points of {title} go over the same stretch more than once: their course is {times:.1f} times as long as it need be</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>{title} の点が同じ区間を何度も通っています。道のりは必要な長さの {times:.1f} 倍です</translation>
  </message>
  <message>
   <source>That is annotated already</source>
   <extracomment>[procc_annotator/calibration/label_check/element_rules.py]</extracomment>
   <translation>それはすでに注釈されています</translation>
  </message>
  <message>
   <source>its corner</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>角</translation>
  </message>
  <message>
   <source>the picture's edge</source>
   <comment>where a line ends</comment>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>画像の縁</translation>
  </message>
  <message>
   <source>move its points onto the line</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>点を線の上に移す</translation>
  </message>
  <message>
   <source>{title} bends: its line is up to {px:.0f} px off between points. Press R to follow it</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} は曲がっています。点の間で線が最大 {px:.0f} px ずれています。R で線に沿わせます</translation>
  </message>
  <message>
   <source>one end of {title} is {px:.0f} px off the line. Move it onto the paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} の端が線から {px:.0f} px ずれています。塗りの上に移してください</translation>
  </message>
  <message>
   <source>{percent:.0f} % of {title} is not on paint (longest gap {px:.0f} px). Line bends? Press R</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} の {percent:.0f} % が塗りの上にありません（最長の途切れ {px:.0f} px）。線が曲がっていれば R を押してください</translation>
  </message>
  <message>
   <source>one end of {title} is not on paint</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} の一端が塗りの上にありません</translation>
  </message>
  <message>
   <source>{title} stops {px:.0f} px short of {what}</source>
   <extracomment>[procc_annotator/calibration/label_check/extent_rules.py]</extracomment>
   <translation>{title} は{what}まで {px:.0f} px 届いていません</translation>
  </message>
  <message>
   <source>look at it</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>確認する</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other points at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>{title} の点 {number} は {off:.0f} px ずれています（ほかの点は最大 {rest:.1f} px）</translation>
  </message>
  <message>
   <source>point {number} of {title} is {off:.0f} px off, its other point at most {rest:.1f} px</source>
   <extracomment>[procc_annotator/calibration/label_check/finding.py]</extracomment>
   <translation>{title} の点 {number} は {off:.0f} px ずれています（もう 1 点は最大 {rest:.1f} px）</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>全体の向きが逆です：奥と手前が入れ替わっています</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>全体の向きが逆です：左と右が入れ替わっています</translation>
  </message>
  <message>
   <source>everything lies the wrong way round: far and near, or left and right, are exchanged</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>全体の向きが逆です：奥と手前、または左と右が入れ替わっています</translation>
  </message>
  <message>
   <source>{title} is on the wrong side of {others}</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{title} は {others} に対して反対側にあります</translation>
  </message>
  <message>
   <source>{titles} lie on each other's side of the elements around them</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} は、周りの要素に対して互いに反対側にあります</translation>
  </message>
  <message>
   <source>{titles} cannot lie this way round to each other, whatever the camera</source>
   <extracomment>[procc_annotator/calibration/label_check/side_rules.py]</extracomment>
   <translation>{titles} の位置関係は、どのカメラでもあり得ません</translation>
  </message>
  <message>
   <source>only {share:.0%} of the lines in sight are on paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py, procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>見える線のうち塗りの上にあるのは {share:.0%} だけです</translation>
  </message>
  <message>
   <source>there is too little paint</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>塗りが少なすぎます</translation>
  </message>
  <message>
   <source>the paint nearby would take a peg from its place</source>
   <extracomment>[procc_annotator/calibration/line_alignment/control_points.py]</extracomment>
   <translation>近くの塗りが杭をその場所からずらしてしまいます</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line, and {more} more are off theirs</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} が線から {px:.0f} px ずれています（ほか {more} 個も）</translation>
  </message>
  <message>
   <source>{name} is {px:.0f} px off its line</source>
   <extracomment>[procc_annotator/calibration/line_alignment/refinement.py]</extracomment>
   <translation>{name} が線から {px:.0f} px ずれています</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, {needed} needed</source>
   <extracomment>{n} element, {needed} needed / {n} elements, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>要素 {n} 個（{needed} 個必要）</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{points} points on {n} elements, two different ones on each of {needed} needed</source>
   <extracomment>{points} points on {n} element, two different ones on each of {needed} needed / {points} points on {n} elements, two different ones on each of {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>{n} 個の要素に {points} 点（{needed} 個の要素にそれぞれ異なる 2 点が必要）</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} elements on the ground, {needed} needed</source>
   <extracomment>{n} element on the ground, {needed} needed / {n} elements on the ground, {needed} needed [procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>
    <numerusform>地面の要素 {n} 個（{needed} 個必要）</numerusform>
   </translation>
  </message>
  <message>
   <source>all points lie in one place of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>すべての点が画像の 1 か所にあります</translation>
  </message>
  <message>
   <source>all points lie on one line of the picture</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>すべての点が画像の 1 本の線上にあります</translation>
  </message>
  <message>
   <source>not a plausible pose: the fit did not settle</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>ありえない姿勢：当てはめが収束しません</translation>
  </message>
  <message>
   <source>not a plausible pose: on the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>ありえない姿勢：地面の上</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.1f} m below the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>ありえない姿勢：地面の {metres:.1f} m 下</translation>
  </message>
  <message>
   <source>not a plausible pose: only {metres:.1f} m above the ground</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>ありえない姿勢：地面からわずか {metres:.1f} m 上</translation>
  </message>
  <message>
   <source>not a plausible pose: {metres:.0f} m from the field's centre</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>ありえない姿勢：フィールド中心から {metres:.0f} m</translation>
  </message>
  <message>
   <source>not a plausible pose: rolled by {degrees:.0f} degrees</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>ありえない姿勢：{degrees:.0f} 度のロール</translation>
  </message>
  <message>
   <source>not a plausible pose: focal length {px:.0f} px at 960 px width</source>
   <extracomment>[procc_annotator/calibration/optimization/camera_placement.py]</extracomment>
   <translation>ありえない姿勢：幅 960 px で焦点距離 {px:.0f} px</translation>
  </message>
  <message>
   <source>pan, tilt or roll ± more than {degrees:g}°, position ± more than {way:g} % of the way to the field's centre, or focal length ± more than {focal:g} %, or clicks that are the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>パン・チルト・ロールが ± {degrees:g}° を超える、位置がフィールド中心までの距離の ± {way:g} % を超える、焦点距離が ± {focal:g} % を超える、または反対側から見ても同じになるクリック</translation>
  </message>
  <message>
   <source>no camera explains these elements together: the best one misses half of them by more than {px:.0f} px (are the labels right?)</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>これらの要素を同時に説明するカメラがありません：最良のものでも半分が {px:.0f} px を超えて外れます（クラスは正しいですか？）</translation>
  </message>
  <message>
   <source>pan ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>パン ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>tilt ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>チルト ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>roll ± {degrees:.1f}°</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>ロール ± {degrees:.1f}°</translation>
  </message>
  <message>
   <source>position ± {metres:.0f} m</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>位置 ± {metres:.0f} m</translation>
  </message>
  <message>
   <source>focal length ± {percent:.0f} %</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>焦点距離 ± {percent:.0f} %</translation>
  </message>
  <message>
   <source>the same from the other end</source>
   <extracomment>[procc_annotator/calibration/result.py]</extracomment>
   <translation>反対側から見ても同じ</translation>
  </message>
  <message>
   <source>a different view fits almost as well</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>別のビューもほぼ同じくらい合います</translation>
  </message>
  <message>
   <source>expected lines are missing</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>あるはずの線がありません</translation>
  </message>
  <message>
   <source>some lines in the picture do not match the field</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>画像内にフィールドと合わない線があります</translation>
  </message>
  <message>
   <source>too few lines in view</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>見える線が少なすぎます</translation>
  </message>
  <message>
   <source>unusual camera position</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>カメラの位置が通常と異なります</translation>
  </message>
  <message>
   <source>the visible lines do not determine the camera</source>
   <extracomment>[procc_annotator/calibration/single_image/probability.py]</extracomment>
   <translation>見える線だけではカメラが定まりません</translation>
  </message>
  <message>
   <source>{lines:.0f} % of expected lines found, {paint:.0f} % of visible paint matched</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>あるはずの線の {lines:.0f} % を検出、見える塗りの {paint:.0f} % と一致</translation>
  </message>
  <message>
   <source>is this {field}? {why}</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>これは {field} ですか？ {why}</translation>
  </message>
  <message>
   <source>no camera fits the lines (best: {shares})</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>線に合うカメラがありません（最良：{shares}）</translation>
  </message>
  <message>
   <source>the picture is nearly square: its pixels may not be</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>画像がほぼ正方形です：画素は正方形でないかもしれません</translation>
  </message>
  <message>
   <source>{field} has no painted lines to look for</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>{field} には探せる線がありません</translation>
  </message>
  <message>
   <source>no camera has its lines on the paint of this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>この画像の塗られた線に合うカメラがありません</translation>
  </message>
  <message>
   <source>there is hardly any paint on the ground in this picture</source>
   <extracomment>[procc_annotator/calibration/single_image/propose.py]</extracomment>
   <translation>この画像の地面には塗られた線がほとんどありません</translation>
  </message>
  <message>
   <source>too little paint in sight</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>見える塗りが少なすぎます</translation>
  </message>
  <message>
   <source>too little of what should be in sight was found</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>見えるはずのものがわずかしか見つかりません</translation>
  </message>
  <message>
   <source>the paint that was found would move the camera too far</source>
   <extracomment>[procc_annotator/calibration/tracking/filter_step.py]</extracomment>
   <translation>見つかった塗りではカメラが動きすぎます</translation>
  </message>
  <message>
   <source>the pixels may not be {aspect:.3f} times as wide as high ({percent:.0f} %)</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>画素の横幅は高さの {aspect:.3f} 倍でないかもしれません（{percent:.0f} %）</translation>
  </message>
  <message>
   <source>the track is {px:.0f} px off the nearest frame whose camera was known</source>
   <extracomment>[procc_annotator/calibration/tracking/shot_tracker.py]</extracomment>
   <translation>追跡は、カメラが既知だった最も近いフレームから {px:.0f} px ずれています</translation>
  </message>
  <message>
   <source>{count} of {total} clicks lie where the camera shows nothing</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>{total} クリックのうち {count} 個はカメラが何も写さない所にあります</translation>
  </message>
  <message>
   <source>the views look at it from nearly the same direction ({degrees:.2f} degrees apart, at least {least:g} are needed)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>各ビューがほぼ同じ方向から見ています（差 {degrees:.2f} 度、{least:g} 度以上必要）</translation>
  </message>
  <message>
   <source>clicked in no view that has a camera</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>カメラのあるどのビューでもクリックされていません</translation>
  </message>
  <message>
   <source>cameras that know only the ground (homographies) have no position in space</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>地面しか知らないカメラ（ホモグラフィ）では空間の位置が分かりません</translation>
  </message>
  <message>
   <source>the lines of sight meet behind the camera of {names}</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>視線が {names} のカメラの後ろで交わります</translation>
  </message>
  <message>
   <source>clicked in one view only</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>1 つのビューでしかクリックされていません</translation>
  </message>
  <message>
   <source>would be farther than {metres:g} m from the field</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>フィールドから {metres:g} m を超えて離れてしまいます</translation>
  </message>
  <message>
   <source>the views do not agree: {far} px off (is it the same place in all of them, and are the cameras right?)</source>
   <extracomment>[procc_annotator/calibration/triangulation.py]</extracomment>
   <translation>ビューが一致しません：ずれ {far} px（すべて同じ場所ですか、カメラは正しいですか？）</translation>
  </message>
  <message>
   <source>Fitted to the clicks of each frame; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>各フレームのクリックへの当てはめ。ファイルには何もありません</translation>
  </message>
  <message>
   <source>the paint is {px:.1f} px from the lines</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>塗りが線から {px:.1f} px 離れています</translation>
  </message>
  <message>
   <source>Followed through the shot; nothing of it is in a file</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>ショットの追跡結果。ファイルには何もありません</translation>
  </message>
  <message>
   <source>no track here: {why}</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>ここには追跡がありません：{why}</translation>
  </message>
  <message>
   <source>no fit of {frame} yet</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>{frame} の当てはめはまだありません</translation>
  </message>
  <message>
   <source>no camera was found</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py, procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>カメラが見つかりませんでした</translation>
  </message>
  <message>
   <source>carried over by the picture's motion, not measured on paint</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>画像の動きから引き継いだもので、塗りでは測っていません</translation>
  </message>
  <message>
   <source>not followed so far</source>
   <extracomment>[procc_annotator/dataset/computed_cameras.py]</extracomment>
   <translation>まだ追跡されていません</translation>
  </message>
  <message>
   <source>{title} was surveyed: its position stays as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} は実測済み：位置は変わりません</translation>
  </message>
  <message>
   <source>{title} moves: its positions hold for an instant each</source>
   <extracomment>[procc_annotator/dataset/landmarks/clicks.py]</extracomment>
   <translation>{title} は動きます：位置はそれぞれ 1 つの瞬間だけのものです</translation>
  </message>
  <message>
   <source>its camera is hardly determined: {what}</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>カメラがほとんど決まりません：{what}</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why}), and {count} more</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>{frame} にカメラがありません（{why}）。ほか {count} フレーム</translation>
  </message>
  <message>
   <source>no camera in {frame} ({why})</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>{frame} にカメラがありません（{why}）</translation>
  </message>
  <message>
   <source>surveyed: kept as it is</source>
   <extracomment>[procc_annotator/dataset/landmarks/triangulation.py]</extracomment>
   <translation>実測済み：そのまま</translation>
  </message>
  <message>
   <source>untouched</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>未着手</translation>
  </message>
  <message>
   <source>in progress</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>作業中</translation>
  </message>
  <message>
   <source>done</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>完了</translation>
  </message>
  <message>
   <source>approved</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>承認済み</translation>
  </message>
  <message>
   <source>rejected</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>差し戻し</translation>
  </message>
  <message>
   <source>clicked</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>クリック</translation>
  </message>
  <message>
   <source>snapped</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>吸着</translation>
  </message>
  <message>
   <source>regularised</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>整形</translation>
  </message>
  <message>
   <source>copied</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>コピー</translation>
  </message>
  <message>
   <source>moved</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>移動</translation>
  </message>
  <message>
   <source>accepted suggestion</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>採用したゴースト</translation>
  </message>
  <message>
   <source>proposed</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>提案</translation>
  </message>
  <message>
   <source>accepted proposal</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>採用した提案</translation>
  </message>
  <message>
   <source>unconfirmed by paint</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>塗りで未確認</translation>
  </message>
  <message>
   <source>from the file</source>
   <comment>points</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>ファイルから</translation>
  </message>
  <message>
   <source>camera</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>カメラ</translation>
  </message>
  <message>
   <source>annotation</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>注釈</translation>
  </message>
  <message>
   <source>fine</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>問題なし</translation>
  </message>
  <message>
   <source>camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>カメラの誤り</translation>
  </message>
  <message>
   <source>labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py]</extracomment>
   <translation>注釈の誤り</translation>
  </message>
  <message>
   <source>OK</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/dataset/records.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>OK</translation>
  </message>
  <message>
   <source>taken back</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>取り消し</translation>
  </message>
  <message>
   <source>saved</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>保存済み</translation>
  </message>
  <message>
   <source>as it was found</source>
   <extracomment>[procc_annotator/dataset/saving.py, procc_annotator/dataset/workspace.py]</extracomment>
   <translation>元の状態</translation>
  </message>
  <message>
   <source>what was saved elsewhere</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>別の場所で保存されたもの</translation>
  </message>
  <message>
   <source>overwritten</source>
   <extracomment>[procc_annotator/dataset/workspace.py]</extracomment>
   <translation>上書き</translation>
  </message>
  <message>
   <source>fitted on these clicks</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>これらのクリックへの当てはめ</translation>
  </message>
  <message>
   <source>fitted to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>これらの注釈の別の版に当てはめたもの</translation>
  </message>
  <message>
   <source>fitted on these clicks, or to another version of these annotations</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>これらのクリック、またはこれらの注釈の別の版に当てはめたもの</translation>
  </message>
  <message>
   <source>closer to these clicks than a prediction can be</source>
   <extracomment>[procc_annotator/formats/cameras/fit_record.py]</extracomment>
   <translation>予測ではあり得ないほどこれらのクリックに近い</translation>
  </message>
  <message>
   <source>by file type and content</source>
   <extracomment>[procc_annotator/formats/cameras/registry.py]</extracomment>
   <translation>ファイルの種類と内容から判断</translation>
  </message>
  <message>
   <source>File</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>ファイル</translation>
  </message>
  <message>
   <source>Edit</source>
   <extracomment>[procc_annotator/gui/actions.py, the action edit_mode, the menus]</extracomment>
   <translation>編集</translation>
  </message>
  <message>
   <source>Frame</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>フレーム</translation>
  </message>
  <message>
   <source>Element</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>要素</translation>
  </message>
  <message>
   <source>View</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/commands/view_grouping.py, the menus]</extracomment>
   <translation>表示</translation>
  </message>
  <message>
   <source>Camera</source>
   <extracomment>[procc_annotator/gui/actions.py, procc_annotator/gui/window/command_palette.py, the menus]</extracomment>
   <translation>カメラ</translation>
  </message>
  <message>
   <source>Help</source>
   <extracomment>[procc_annotator/gui/actions.py, the menus]</extracomment>
   <translation>ヘルプ</translation>
  </message>
  <message>
   <source>The picture cannot be shown</source>
   <extracomment>[procc_annotator/gui/canvas/annotation_preview.py]</extracomment>
   <translation>画像を表示できません</translation>
  </message>
  <message>
   <source>no camera is known here that could be dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>ここには動かせるカメラがありません</translation>
  </message>
  <message>
   <source>taken back: the camera is as before it was dragged</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>取り消しました：カメラは動かす前に戻りました</translation>
  </message>
  <message>
   <source>overlays are hidden (Ctrl+H)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>重ね描きは非表示です（Ctrl+H）</translation>
  </message>
  <message>
   <source>a homography cannot be turned: choose another model (panel Fit)</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>ホモグラフィは回せません。別のモデルを選んでください（当てはめパネル）</translation>
  </message>
  <message>
   <source>release leaves it here</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>離すとここに残ります</translation>
  </message>
  <message>
   <source>Esc puts it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py, procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc で元に戻します</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs hold the camera</source>
   <extracomment>{n} peg holds the camera / {n} pegs hold the camera [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>{n} 本の杭がカメラを留めています</numerusform>
   </translation>
  </message>
  <message>
   <source>CAMERA</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>カメラ</translation>
  </message>
  <message numerus="yes">
   <source>peg taken away: {n} pegs left</source>
   <extracomment>peg taken away: {n} peg left / peg taken away: {n} pegs left [procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>
    <numerusform>杭を取り除きました：残り {n} 本</numerusform>
   </translation>
  </message>
  <message>
   <source>peg taken away: the camera is as it was found</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>杭を取り除きました：カメラは求めたときのままです</translation>
  </message>
  <message>
   <source>peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>杭</translation>
  </message>
  <message>
   <source>press on a line of the wireframe</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>ワイヤーフレームの線を押してください</translation>
  </message>
  <message>
   <source>drag moves this peg</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>ドラッグでこの杭を動かす</translation>
  </message>
  <message>
   <source>click takes it away</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>クリックで取り除く</translation>
  </message>
  <message>
   <source>drag a place of the wireframe to where it belongs</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>ワイヤーフレームの場所を正しい位置へドラッグ</translation>
  </message>
  <message>
   <source>drag {title} to where it belongs: the camera follows</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>{title} を正しい位置へドラッグ：カメラが追従</translation>
  </message>
  <message>
   <source>Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/canvas/camera_drag.py]</extracomment>
   <translation>Ctrl+Z で取り消し</translation>
  </message>
  <message>
   <source>Picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py, procc_annotator/gui/settings.py, procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>画像</translation>
  </message>
  <message>
   <source>PAN</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>移動</translation>
  </message>
  <message>
   <source>drag moves the picture</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>ドラッグで画像を動かす</translation>
  </message>
  <message>
   <source>Esc takes the tool again</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>Esc でツールに戻る</translation>
  </message>
  <message>
   <source>load a second set of cameras to blink between two (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/canvas/canvas.py]</extracomment>
   <translation>2 つを切り替えて見るには 2 つ目のカメラセットを読み込んでください（Ctrl+L）</translation>
  </message>
  <message>
   <source>crosshair: the arrows move it (Shift 0.1 px, Ctrl 10 px, Ctrl+Shift 100 px), Space clicks, Esc puts it away</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>十字カーソル：矢印キーで移動（Shift 0.1 px、Ctrl 10 px、Ctrl+Shift 100 px）、Space でクリック、Esc で消す</translation>
  </message>
  <message>
   <source>point at a line first: with the mouse, or with the arrows</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>まず線を指してください：マウスまたは矢印キーで</translation>
  </message>
  <message>
   <source>there is no line here to put a point on</source>
   <extracomment>[procc_annotator/gui/canvas/canvas_keys.py]</extracomment>
   <translation>ここには点を置ける線がありません</translation>
  </message>
  <message>
   <source>camera unreadable</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>カメラを読めません</translation>
  </message>
  <message>
   <source>no camera here</source>
   <extracomment>[procc_annotator/gui/canvas/comparison.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>ここにはカメラなし</translation>
  </message>
  <message>
   <source>next: {title}</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>次：{title}</translation>
  </message>
  <message>
   <source>{title}  ±{sd:.1f} px  unsure</source>
   <extracomment>[procc_annotator/gui/canvas/drawing.py]</extracomment>
   <translation>{title}  ±{sd:.1f} px  不確か</translation>
  </message>
  <message>
   <source>{title} has no points in this frame: choose the element to delete</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} の点はこのフレームにありません。削除する要素を選んでください</translation>
  </message>
  <message>
   <source>choose the element to delete first: field map, list, or its key</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>まず削除する要素を選んでください：フィールド図、一覧、またはそのキー</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} points of {title}</source>
   <extracomment>dropped {n} point of {title} / dropped {n} points of {title} [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>{title} の {n} 点を捨てました</numerusform>
   </translation>
  </message>
  <message>
   <source>{titles}: changed elsewhere, look again first</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{titles}：別の場所で変更されました。もう一度確認してください</translation>
  </message>
  <message numerus="yes">
   <source>kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on</source>
   <extracomment>kept {n} click of {title} on {frame}, unfinished: choose it there to go on / kept {n} clicks of {title} on {frame}, unfinished: choose it there to go on [procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>
    <numerusform>{frame} の {title} のクリック {n} 個を描きかけで保持しました：続けるにはそこで選んでください</numerusform>
   </translation>
  </message>
  <message>
   <source>finished {title}</source>
   <extracomment>[procc_annotator/gui/canvas/editor.py]</extracomment>
   <translation>{title} を終えました</translation>
  </message>
  <message>
   <source>How good the fitted camera is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>当てはめたカメラの精度</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>地面上のメートル、1 標準偏差</translation>
  </message>
  <message>
   <source>How good the fitted camera ({model}) is</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>当てはめたカメラ（{model}）の精度</translation>
  </message>
  <message>
   <source>{metres:g} m, asked of offside technology</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m、オフサイド判定技術の要求</translation>
  </message>
  <message>
   <source>metres on the ground, 1 sd, median {median:.2f}</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>地面上のメートル、1 標準偏差、中央値 {median:.2f}</translation>
  </message>
  <message>
   <source>metres on the ground</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>地面上のメートル</translation>
  </message>
  <message>
   <source>{metres:g} m: {percent:.0f} % of the field in sight</source>
   <extracomment>[procc_annotator/gui/canvas/metre_maps.py]</extracomment>
   <translation>{metres:g} m：見えるフィールドの {percent:.0f} %</translation>
  </message>
  <message>
   <source>Blind: no camera is shown before Ctrl+Enter</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>ブラインド：Ctrl+Enter までカメラを表示しません</translation>
  </message>
  <message>
   <source>Blind mode, this frame is committed</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>ブラインドモード、このフレームは提出済み</translation>
  </message>
  <message numerus="yes">
   <source>{n} pegs</source>
   <extracomment>{n} peg / {n} pegs [procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>
    <numerusform>杭 {n} 本</numerusform>
   </translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, made exact on paint: {share:.0%} of its lines</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>カメラを移動、{pegs}、塗りに合わせて精密化：線の {share:.0%}</translation>
  </message>
  <message>
   <source>Camera found, unsure: {why}. Shift+Enter accepts, Delete rejects it</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>カメラを検出、不確か：{why}。Shift+Enter で受け入れ、Delete で却下</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}, not made exact: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>カメラを移動、{pegs}、精密化できません：{why}</translation>
  </message>
  <message>
   <source>Drag to move the divider (arrow keys do it too)</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>ドラッグで仕切りを動かします（矢印キーも可）</translation>
  </message>
  <message>
   <source>Divider of the split view</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>分割表示の仕切り</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>カメラを移動、{pegs}</translation>
  </message>
  <message>
   <source>Camera of the track: Shift+Enter accepts its elements</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>追跡のカメラ：Shift+Enter で要素を採用</translation>
  </message>
  <message>
   <source>Looking for the camera in the picture …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>画像からカメラを探しています…</translation>
  </message>
  <message>
   <source>No camera found: {why}. To begin, {advice} (Enter takes the first). Another sport? Click here</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>カメラが見つかりません：{why}。まず{advice}（Enter で最初の要素を選択）。ほかの競技ならここをクリック</translation>
  </message>
  <message>
   <source>Camera found, sure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>カメラを検出、確か：{why}</translation>
  </message>
  <message>
   <source>Camera dragged, {pegs}: its lines are looked for …</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>カメラを移動、{pegs}：線を探しています…</translation>
  </message>
  <message>
   <source>Camera of the track, unsure: {why}</source>
   <extracomment>[procc_annotator/gui/canvas/viewport_overlays.py]</extracomment>
   <translation>追跡のカメラ、不確か：{why}</translation>
  </message>
  <message>
   <source>nothing changed: regular already, or no painted line was found there</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>変更なし：すでに整っているか、塗られた線が見つかりませんでした</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, along the track; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} から{what}を追跡に沿ってコピーしました。Shift+V ですべて確定</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, moved with the camera; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} から{what}をカメラの動きに合わせてコピーしました。Shift+V ですべて確定</translation>
  </message>
  <message>
   <source>copied {what} from {frame}, as they were: no motion found; Shift+V confirms all</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} から{what}をそのままコピーしました：動きが求まりません。Shift+V ですべて確定</translation>
  </message>
  <message>
   <source>taken back: nothing is regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>取り消しました：何も整えていません</translation>
  </message>
  <message>
   <source>taken back: nothing is copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>取り消しました：何もコピーしていません</translation>
  </message>
  <message>
   <source>the frame was left: nothing was regularised</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>フレームを離れたため、何も整えませんでした</translation>
  </message>
  <message>
   <source>the frame was left: nothing was copied</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>フレームを離れたため、何もコピーしませんでした</translation>
  </message>
  <message numerus="yes">
   <source>{n} points unconfirmed by paint</source>
   <extracomment>{n} point unconfirmed by paint / {n} points unconfirmed by paint [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>塗りで確かめられない点 {n} 個</numerusform>
   </translation>
  </message>
  <message>
   <source>regularise {what}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{what}を整える</translation>
  </message>
  <message>
   <source>copy from {frame}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} からコピー</translation>
  </message>
  <message>
   <source>left out, not in the picture or no line seen: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>省略（画像外、または線が見えない）：{elements}</translation>
  </message>
  <message>
   <source>choose an annotated element first</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>まず注釈済みの要素を選んでください</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements</source>
   <extracomment>{n} element / {n} elements [procc_annotator/gui/commands/assistant.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>
    <numerusform>要素 {n} 個</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>regularised {what}: {n} points</source>
   <extracomment>regularised {what}: {n} point / regularised {what}: {n} points [procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>
    <numerusform>{what}を整えました：{n} 点</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} has corners or is one place: it stays as it is</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{element} には角があるか 1 点だけなので、そのままにします</translation>
  </message>
  <message>
   <source>no element of the field is annotated here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>ここにはフィールドの要素が注釈されていません</translation>
  </message>
  <message>
   <source>no frame before this one is annotated</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>これより前に注釈済みのフレームはありません</translation>
  </message>
  <message>
   <source>{frame} has no element that is missing here</source>
   <extracomment>[procc_annotator/gui/commands/assistant.py]</extracomment>
   <translation>{frame} には、ここにない要素がありません</translation>
  </message>
  <message>
   <source>{element} becomes {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} を {other} に変更</translation>
  </message>
  <message>
   <source>duplicate {element} as {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} を {other} として複製</translation>
  </message>
  <message>
   <source>merge {element} into {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} を {other} に統合</translation>
  </message>
  <message>
   <source>close gaps</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>すき間を閉じる</translation>
  </message>
  <message numerus="yes">
   <source>confirm {n} elements</source>
   <extracomment>confirm {n} element / confirm {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>要素 {n} 個を確定</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>drop {n} unconfirmed elements</source>
   <extracomment>drop {n} unconfirmed element / drop {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>未確定の要素 {n} 個を捨てる</numerusform>
   </translation>
  </message>
  <message>
   <source>Name of the line</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>線の名前</translation>
  </message>
  <message>
   <source>What is this line?</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>この線は何ですか？</translation>
  </message>
  <message>
   <source>{element} is a curve, which two points do not show: click on</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} は曲線で、2 点では表せません：クリックを続けてください</translation>
  </message>
  <message>
   <source>swap {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} と {other} を入れ替え</translation>
  </message>
  <message>
   <source>{element} is its own symmetric element</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} は自分自身が対称クラスです</translation>
  </message>
  <message numerus="yes">
   <source>{elements} are annotated already</source>
   <extracomment>{elements} is annotated already / {elements} are annotated already [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>{elements} はすでに注釈済みです</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} lies where {other} is: drag it to its place</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} が {other} と同じ位置にあります。所定の位置へ動かしてください</translation>
  </message>
  <message>
   <source>reverse {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} の向きを逆にする</translation>
  </message>
  <message>
   <source>choose the point to split at first (edit mode)</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>まず分割する点を選んでください（編集モード）</translation>
  </message>
  <message>
   <source>split {element}</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} を分割</translation>
  </message>
  <message numerus="yes">
   <source>confirmed {n} elements</source>
   <extracomment>confirmed {n} element / confirmed {n} elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>要素 {n} 個を確定しました</numerusform>
   </translation>
  </message>
  <message>
   <source>nothing is unconfirmed on this frame</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>このフレームに未確定のものはありません</translation>
  </message>
  <message>
   <source>{element} is annotated already</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} はすでに注釈されています</translation>
  </message>
  <message>
   <source>no end is that near to a corner or the picture's edge</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>角や画像の縁にそれほど近い端はありません</translation>
  </message>
  <message numerus="yes">
   <source>dropped {n} unconfirmed elements</source>
   <extracomment>dropped {n} unconfirmed element / dropped {n} unconfirmed elements [procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>
    <numerusform>未確定の要素 {n} 個を捨てました</numerusform>
   </translation>
  </message>
  <message>
   <source>Another element…</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>別の要素…</translation>
  </message>
  <message>
   <source>Leave it unnamed</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>名前を付けない</translation>
  </message>
  <message>
   <source>an element is split at a point between its ends, into a class that is free</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>要素は両端以外の点で、空いているクラスへ分割します</translation>
  </message>
  <message>
   <source>{element} was changed elsewhere: look at it again</source>
   <extracomment>[procc_annotator/gui/commands/element_edits.py]</extracomment>
   <translation>{element} は別の場所で変更されました。もう一度確認してください</translation>
  </message>
  <message>
   <source>? (stays as it is, an unknown class)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>?（そのまま、未知のクラス）</translation>
  </message>
  <message>
   <source>Leave out</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, the action off_plane_left_out, the setting off_plane]</extracomment>
   <translation>除外する</translation>
  </message>
  <message>
   <source>Label</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>ラベル</translation>
  </message>
  <message>
   <source>Shapes</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>図形</translation>
  </message>
  <message>
   <source>Stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>対応先</translation>
  </message>
  <message>
   <source>Why</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>理由</translation>
  </message>
  <message>
   <source>sure</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>確か</translation>
  </message>
  <message>
   <source>likely</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>有力</translation>
  </message>
  <message>
   <source>to be said</source>
   <comment>a proposal</comment>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>要指定</translation>
  </message>
  <message numerus="yes">
   <source>{n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on.</source>
   <extracomment>{n} label is no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. / {n} labels are no class of {field}. Say what they stand for; what is proposed was told by their words, and by which elements their shapes lie on. [procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>
    <numerusform>{n} 個のラベルは {field} のクラスではありません。何に対応するかを指定してください。候補は、語と、図形がどの要素の上にあるかから選びました。</numerusform>
   </translation>
  </message>
  <message>
   <source>These names are more like those of {field}: choose that field first (File &gt; Field).</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>これらの名前は {field} のものに近いようです。先にそのフィールドを選んでください（ファイル &gt; フィールド）。</translation>
  </message>
  <message>
   <source>Names of another program</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>ほかのプログラムの名前</translation>
  </message>
  <message>
   <source>Keep these names with the dataset ({file})</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>これらの名前をデータセットに保存する（{file}）</translation>
  </message>
  <message>
   <source>Import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>取り込む</translation>
  </message>
  <message>
   <source>What {label} stands for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>{label} の対応先</translation>
  </message>
  <message>
   <source>What came of it</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>結果</translation>
  </message>
  <message>
   <source>Import annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>注釈を取り込む</translation>
  </message>
  <message>
   <source>Annotations to import</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>取り込む注釈</translation>
  </message>
  <message>
   <source>Look into the files</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>ファイルを調べる</translation>
  </message>
  <message>
   <source>Only frames without annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>まだ注釈のないフレームだけ</translation>
  </message>
  <message>
   <source>Replace what is annotated in the others, too</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>ほかのフレームの注釈も置き換える</translation>
  </message>
  <message>
   <source>What was there stays among the earlier versions of its frame, and undo brings it back</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>前の内容はフレームの以前の版に残り、元に戻すでも復元できます</translation>
  </message>
  <message>
   <source>Annotations</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>注釈</translation>
  </message>
  <message>
   <source>Format</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>形式</translation>
  </message>
  <message>
   <source>Import into</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>取り込み先</translation>
  </message>
  <message>
   <source>Annotations (*.json *.xml *.zip);;All files (*)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>注釈 (*.json *.xml *.zip);;すべてのファイル (*)</translation>
  </message>
  <message>
   <source>Export as</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>形式を選んで書き出す</translation>
  </message>
  <message>
   <source>Export…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>書き出す…</translation>
  </message>
  <message>
   <source>One zip archive instead of a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>フォルダーの代わりに 1 つの zip にする</translation>
  </message>
  <message>
   <source>Replace files that are there</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>既存のファイルを置き換える</translation>
  </message>
  <message>
   <source>Keep elements that SoccerNet has no class for</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>SoccerNet にクラスのない要素も残す</translation>
  </message>
  <message>
   <source>Width of the lines</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>線の幅</translation>
  </message>
  <message>
   <source>Copy the pictures as well</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>画像もコピーする</translation>
  </message>
  <message>
   <source>Export to a folder</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>フォルダーに書き出す</translation>
  </message>
  <message>
   <source>Keeps {holds}.
Loses {loses}.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>残るもの：{holds}。
失われるもの：{loses}。</translation>
  </message>
  <message>
   <source>Add these names to the dataset's {file}, written anew</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>これらの名前をデータセットの {file} に加え、書き直します</translation>
  </message>
  <message>
   <source>Cancel</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/messages.py]</extracomment>
   <translation>取り消し</translation>
  </message>
  <message>
   <source>Close</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>閉じる</translation>
  </message>
  <message>
   <source>A folder, a zip archive, or one file</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>フォルダー、zip、または 1 つのファイル</translation>
  </message>
  <message>
   <source>File…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>ファイル…</translation>
  </message>
  <message>
   <source>Folder…</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>フォルダー…</translation>
  </message>
  <message>
   <source>Frames are matched by the name of their picture.</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>フレームは画像の名前で対応付けます。</translation>
  </message>
  <message>
   <source>Zip archive (*.zip)</source>
   <extracomment>[procc_annotator/gui/commands/exchange_dialogs.py]</extracomment>
   <translation>zip (*.zip)</translation>
  </message>
  <message>
   <source>{frames}, {elements} and {points} written to {path} ({format}).</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frames}、{elements}、{points}を {path} に書き出しました（{format}）。</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} annotations</source>
   <extracomment>{n:,} annotation / {n:,} annotations [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} 件の注釈</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>JaC of {n:,} frames</source>
   <extracomment>JaC of {n:,} frame / JaC of {n:,} frames [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームの JaC</numerusform>
   </translation>
  </message>
  <message>
   <source>Not everything could be saved: what is on disk goes.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>すべては保存できませんでした：ディスク上の内容を書き出します。</translation>
  </message>
  <message>
   <source>Nothing was written: no frame is annotated, or none could be written.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>何も書き出していません：注釈のあるフレームがないか、どれも書き出せませんでした。</translation>
  </message>
  <message>
   <source>the fit of {frame} is saved as {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frame} の当てはめを {path} に保存しました</translation>
  </message>
  <message>
   <source>{source} is made from the clicks it would be scored against: judge the cameras to be scored (procc-annotator calibrate fits and scores a set)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{source} は採点に使うクリック自身から作られています。採点するカメラを評価してください（procc-annotator calibrate はセットを当てはめて採点します）</translation>
  </message>
  <message>
   <source>{annotations} and {scores}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{annotations}と{scores}</translation>
  </message>
  <message>
   <source>nothing: no frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>書き出すものがありません：注釈のあるフレームがありません</translation>
  </message>
  <message>
   <source>export: cancelled; files that were written already are still there</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>書き出しを取り消しました。すでに書き出したファイルは残っています</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames</source>
   <extracomment>{n:,} frame / {n:,} frames [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/opening.py, procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレーム</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} elements</source>
   <extracomment>{n:,} element / {n:,} elements [procc_annotator/gui/commands/exporting.py, procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>要素 {n:,} 個</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points</source>
   <extracomment>{n:,} point / {n:,} points [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} 点</numerusform>
   </translation>
  </message>
  <message>
   <source>Zip archive (*.zip);;Folder (*)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>zip (*.zip);;フォルダー (*)</translation>
  </message>
  <message>
   <source>Save copies to</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>コピーの保存先</translation>
  </message>
  <message numerus="yes">
   <source>copied {n:,} frames to {folder}; they are not saved in their own place yet</source>
   <extracomment>copied {n:,} frame to {folder}; it is not saved in its own place yet / copied {n:,} frames to {folder}; they are not saved in their own place yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを {folder} にコピーしました。本来の場所にはまだ保存されていません</numerusform>
   </translation>
  </message>
  <message>
   <source>Table (*.csv);;JSON (*.json)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>表 (*.csv);;JSON (*.json)</translation>
  </message>
  <message>
   <source>Table (*.csv)</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py, procc_annotator/gui/commands/label_check.py, procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>表 (*.csv)</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} frames to {path}</source>
   <extracomment>exported {n:,} frame to {path} / exported {n:,} frames to {path} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを {path} に書き出しました</numerusform>
   </translation>
  </message>
  <message>
   <source>the set was being scored still: some frames have no JaC yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>セットはまだ採点中でした：JaC のないフレームがあります</translation>
  </message>
  <message>
   <source>no camera to save: the fit is not there yet</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>保存するカメラがありません：当てはめがまだです</translation>
  </message>
  <message>
   <source>blind: no frame is committed yet, so there is no JaC to show</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>ブラインド：提出済みのフレームがまだないため、示せる JaC がありません</translation>
  </message>
  <message>
   <source>exported {what} to {path}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{what}を {path} に書き出しました</translation>
  </message>
  <message>
   <source>Cancelled; files that were written already are still there.</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>取り消しました。すでに書き出したファイルは残っています。</translation>
  </message>
  <message>
   <source>Not written</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>書き出せなかったもの</translation>
  </message>
  <message>
   <source>What the format cannot hold</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>この形式で保持できないもの</translation>
  </message>
  <message>
   <source>everything is saved in its own place</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>すべて本来の場所に保存済みです</translation>
  </message>
  <message>
   <source>no camera to save: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>保存するカメラがありません：{why}</translation>
  </message>
  <message>
   <source>the fit is worked out again: save it in a moment</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>当てはめを計算し直しています。少し後で保存してください</translation>
  </message>
  <message>
   <source>{frame}: the picture cannot be read, so that the camera's pixels belong to no size; not saved</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{frame}：画像を読めないため、カメラのピクセルの基準となるサイズがありません。保存していません</translation>
  </message>
  <message>
   <source>saved as {path}, but the loaded cameras could not be read again: {problem}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{path} に保存しましたが、読み込んだカメラを読み直せませんでした：{problem}</translation>
  </message>
  <message>
   <source>{saved}; it is hardly determined: {why}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>{saved}。ほぼ決まっていません：{why}</translation>
  </message>
  <message>
   <source>not everything could be saved: the export has the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>すべては保存できませんでした：書き出したのは最後に保存した状態です</translation>
  </message>
  <message numerus="yes">
   <source>blind mode leaves out {n:,} frames not committed yet</source>
   <extracomment>blind mode leaves out {n:,} frame not committed yet / blind mode leaves out {n:,} frames not committed yet [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>ブラインドモードのため、未提出の {n:,} フレームを除きます</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} files could not be read: {problem}</source>
   <extracomment>{n:,} file could not be read: {problem} / {n:,} files could not be read: {problem} [procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>
    <numerusform>{n:,} ファイルを読めませんでした：{problem}</numerusform>
   </translation>
  </message>
  <message>
   <source>Export</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>書き出す</translation>
  </message>
  <message>
   <source>exporting {done} / {total}</source>
   <extracomment>[procc_annotator/gui/commands/exporting.py]</extracomment>
   <translation>書き出し {done} / {total}</translation>
  </message>
  <message>
   <source>Keep the field, and say nothing more of these classes</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>フィールドはそのままとし、これらのクラスについて今後尋ねません</translation>
  </message>
  <message>
   <source>The dataset remembers it, and is not asked about again</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>データセットが記憶し、今後は尋ねません</translation>
  </message>
  <message>
   <source>No, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>いいえ、{field}</translation>
  </message>
  <message>
   <source>The field of this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>このデータセットのフィールド</translation>
  </message>
  <message>
   <source>Descriptions of fields (*.toml)</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>フィールドの定義 (*.toml)</translation>
  </message>
  <message>
   <source>Is this {field}? The classes annotated here are those of {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>これは {field} ですか？ここで注釈されたクラスは {field} のものです</translation>
  </message>
  <message>
   <source>{why}, but {file} in the dataset's folder decides</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{why}。ただしデータセットのフォルダーの {file} が優先されます</translation>
  </message>
  <message>
   <source>Yes, {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>はい、{field}</translation>
  </message>
  <message>
   <source>Switch to {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{field} に切り替える</translation>
  </message>
  <message>
   <source>{problem}; the field stays as it was: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_choosing.py]</extracomment>
   <translation>{problem}。フィールドは変わりません：{field}</translation>
  </message>
  <message>
   <source>Scores then differ from those of the nominal field ({nominal}), as official evaluations take it; they name the dimensions they were computed with.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>スコアは、公式評価が用いる公称フィールド（{nominal}）のものと異なります。計算に使った寸法が記されます。</translation>
  </message>
  <message>
   <source>Dimensions of their own (stadiums.csv): {frames} of {stadiums}. What is entered here is for all others, and for what stadiums leave open.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>独自の寸法（stadiums.csv）：{stadiums}の{frames}。ここでの入力は、それ以外と、スタジアムの定めていない寸法に使われます。</translation>
  </message>
  <message>
   <source>Scores then differ from those of official evaluations, which take lines where the rules measure them; they say so.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>スコアは公式評価のものと異なります。公式評価では規則の測る位置を線とします。スコアにその旨が記されます。</translation>
  </message>
  <message>
   <source>Rules measure many lines at an edge of their paint. Clicks are put on its middle, half the paint's width away: choose it where that matters, as in halls and near the camera.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>規則では多くの線を塗りの縁で測ります。クリックは塗りの中央、つまり幅の半分だけ離れた位置に置かれます。屋内競技やカメラに近い場合など、差が問題になるときに選んでください。</translation>
  </message>
  <message>
   <source>Only length and width are found from frames, and the rules fix those of this field</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>フレームから求められるのは長さと幅だけで、このフィールドでは規則で決まっています</translation>
  </message>
  <message numerus="yes">
   <source>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames.</source>
   <extracomment>{dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frame. / {dimension}: {value:.2f} ± {sd:.2f} m, told by {n} frames. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{dimension}：{value:.2f} ± {sd:.2f} m、{n} フレームから。</numerusform>
   </translation>
  </message>
  <message>
   <source>where the rules measure</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>規則の測る位置</translation>
  </message>
  <message>
   <source>the middle of the paint</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>塗りの中央</translation>
  </message>
  <message>
   <source>Field dimensions: {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>フィールドの寸法：{field}</translation>
  </message>
  <message numerus="yes">
   <source>From the cameras of {n} frames; ± is one standard deviation.</source>
   <extracomment>From the cameras of {n} frame; ± is one standard deviation. / From the cameras of {n} frames; ± is one standard deviation. [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} フレームのカメラから。± は 1 標準偏差。</numerusform>
   </translation>
  </message>
  <message>
   <source>{remark}; it stays as it was.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>{remark}。元のままです。</translation>
  </message>
  <message>
   <source>Estimate from this set</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>このセットから推定</translation>
  </message>
  <message>
   <source>Clicks lie on:</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>クリックの位置：</translation>
  </message>
  <message>
   <source>Keep for this dataset</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>このデータセットに保存</translation>
  </message>
  <message>
   <source>Nominal</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>公称値</translation>
  </message>
  <message>
   <source>The field as official evaluations take it</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>公式評価が用いるフィールド</translation>
  </message>
  <message>
   <source>nominal {nominal:g} m, the rules allow {minimum:g} to {maximum:g} m</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>公称 {nominal:g} m、規則では {minimum:g}～{maximum:g} m</translation>
  </message>
  <message>
   <source>&lt;b&gt;not {number:g} m: the rules allow {minimum:g} to {maximum:g} m&lt;/b&gt;</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>&lt;b&gt;{number:g} m は不可：規則では {minimum:g}～{maximum:g} m&lt;/b&gt;</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames</source>
   <extracomment>{n} frame / {n} frames [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} フレーム</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n} stadiums</source>
   <extracomment>{n} stadium / {n} stadiums [procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>
    <numerusform>{n} スタジアム</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: frames that are not committed took no part ({n}).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>ブラインド：提出していないフレームは対象外です（{n}）。</translation>
  </message>
  <message>
   <source>Frames that cannot be read took no part: {n}.</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>読めないフレームは対象外です：{n}。</translation>
  </message>
  <message>
   <source>Stop</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py, procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>停止</translation>
  </message>
  <message>
   <source>the rules fix every dimension of the field {field}</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>フィールド {field} の寸法はすべて規則で決まっています</translation>
  </message>
  <message>
   <source>Blind: the set is checked once one of its frames is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/commands/field_dimensions.py]</extracomment>
   <translation>ブラインド：1 フレームを提出するとセットを調べます（Ctrl+Enter）。</translation>
  </message>
  <message>
   <source>no further frame this way: {what}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>この方向にはもうフレームがありません：{what}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: JaC {value:.3f}</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{total} 中 {place} 番目に悪い：JaC {value:.3f}</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: largest error {value:.1f} px</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{total} 中 {place} 番目に悪い：最大誤差 {value:.1f} px</translation>
  </message>
  <message>
   <source>{place} of {total}, worst first: median disagreement {value:.2f} m</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{total} 中 {place} 番目に悪い：不一致の中央値 {value:.2f} m</translation>
  </message>
  <message>
   <source>{place} of {total}, the least sure first</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{total} 中 {place} 番目に不確か</translation>
  </message>
  <message>
   <source>none is annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>注釈済みはありません</translation>
  </message>
  <message>
   <source>all are annotated</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>すべて注釈済みです</translation>
  </message>
  <message>
   <source>all are done or approved</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>すべて完了または承認済みです</translation>
  </message>
  <message>
   <source>none is rejected</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>差し戻しはありません</translation>
  </message>
  <message>
   <source>this is the last one</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>これが最後です</translation>
  </message>
  <message>
   <source>no frame with a score to go to</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>移れるスコア付きのフレームがありません</translation>
  </message>
  <message>
   <source>no frame with a score to go to: blind mode shows those of committed frames only</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>移れるスコア付きのフレームがありません：ブラインドモードでは提出済みのフレームだけを示します</translation>
  </message>
  <message>
   <source>comparing {source} with {other} over the set</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>セット全体で {source} と {other} を比較しています</translation>
  </message>
  <message>
   <source>blind mode: how the track does is hidden</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ブラインドモード：追跡の良し悪しは隠されます</translation>
  </message>
  <message>
   <source>no shot was followed yet (T)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>まだショットを追跡していません（T）</translation>
  </message>
  <message>
   <source>no other frame is unsure</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ほかに不確かなフレームはありません</translation>
  </message>
  <message>
   <source>these frames do not follow one another</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>これらのフレームは連続していません</translation>
  </message>
  <message>
   <source>two sources are needed to see where they disagree: load more cameras (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>不一致を見るにはソースが 2 つ必要です。カメラをもう 1 つ読み込んでください（Ctrl+L）</translation>
  </message>
  <message>
   <source>{source} and {other} cannot be compared on the ground in any frame</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} と {other} を地面上で比較できるフレームがありません</translation>
  </message>
  <message>
   <source>stopped comparing the sources</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ソースの比較を止めました</translation>
  </message>
  <message>
   <source>this is the worst; once more goes on</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>これが最も悪いフレームです。もう一度で次へ</translation>
  </message>
  <message>
   <source>no other frame has a score</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>ほかにスコアのあるフレームはありません</translation>
  </message>
  <message>
   <source>from the worst again</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>最も悪いフレームから再び</translation>
  </message>
  <message>
   <source>two sources are being compared already</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>すでに 2 つのソースを比較しています</translation>
  </message>
  <message>
   <source>{source} and {other} are compared</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>{source} と {other} を比較しました</translation>
  </message>
  <message>
   <source>none is doubtful</source>
   <extracomment>[procc_annotator/gui/commands/frame_walks.py]</extracomment>
   <translation>疑わしいものはありません</translation>
  </message>
  <message>
   <source>skipped (under {least:.0%} visible): {ghosts}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>除外（見えるのが {least:.0%} 未満）：{ghosts}</translation>
  </message>
  <message numerus="yes">
   <source>{n} points</source>
   <extracomment>{n} point / {n} points [procc_annotator/gui/commands/ghost_accepting.py, procc_annotator/gui/commands/versions.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>
    <numerusform>{n} 点</numerusform>
   </translation>
  </message>
  <message>
   <source>{accepted}: {points}, line seen along {share:.0%}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{accepted}：{points}、線の見え方 {share:.0%}</translation>
  </message>
  <message numerus="yes">
   <source>{n} ends of {elements} cannot be seen: the points stop before</source>
   <extracomment>{n} end of {elements} cannot be seen: the points stop before / {n} ends of {elements} cannot be seen: the points stop before [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>{elements} の {n} 端は見えません：点は手前で止まります</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera is another one meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>その間にカメラが変わりました</translation>
  </message>
  <message>
   <source>accept {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what}を採用</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts</source>
   <extracomment>{n} ghost / {n} ghosts [procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>
    <numerusform>ゴースト {n} 個</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ghosts</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{total} 中 {n} 個のゴースト</translation>
  </message>
  <message>
   <source>accepted {what}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{what}を採用しました</translation>
  </message>
  <message>
   <source>the frame was edited meanwhile</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>その間にフレームが編集されました</translation>
  </message>
  <message>
   <source>looking for the line on {frame} took too long</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{frame} で線を探すのに時間がかかりすぎました</translation>
  </message>
  <message>
   <source>{element} is not accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} は採用されません：{why}</translation>
  </message>
  <message>
   <source>{element}: no painted line is found along it; click it by hand, or say that it is not visible here (.)</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element}：沿った塗りの線が見つかりません。手でクリックするか、ここでは見えないとしてください（.）</translation>
  </message>
  <message>
   <source>the camera is being fitted: accept its ghosts in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>カメラを当てはめ中です。ゴーストは少し後で採用してください</translation>
  </message>
  <message>
   <source>no ghost accepted, under {least:.0%} of the line visible: {ghosts}; Tab goes through them</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>採用したゴーストはありません。見える線が {least:.0%} 未満：{ghosts}。Tab で順に見ます</translation>
  </message>
  <message>
   <source>accepted {what} on {frame}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{frame} で{what}を採用しました</translation>
  </message>
  <message>
   <source>no ghost was accepted: there is no picture to look for their lines in</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>採用したゴーストはありません：線を探す画像がありません</translation>
  </message>
  <message>
   <source>no ghost was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>採用したゴーストはありません：{why}</translation>
  </message>
  <message>
   <source>{element} is not accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} は採用されません</translation>
  </message>
  <message>
   <source>the ghost is accepted: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>ゴーストを採用しました。新しい当てはめのゴーストを採用してください</translation>
  </message>
  <message>
   <source>what was being drawn is finished: accept the ghosts of the new fit</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>描画中のものを終えました。新しい当てはめのゴーストを採用してください</translation>
  </message>
  <message>
   <source>no ghost was accepted</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>採用したゴーストはありません</translation>
  </message>
  <message>
   <source>{element} is accepted once its points are found</source>
   <extracomment>[procc_annotator/gui/commands/ghost_accepting.py]</extracomment>
   <translation>{element} は点が見つかり次第採用します</translation>
  </message>
  <message>
   <source>go to a ghost (Tab) or choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>まずゴーストへ移るか（Tab）、要素を選んでください</translation>
  </message>
  <message numerus="yes">
   <source>{n} ghosts left, Tab begins again</source>
   <extracomment>{n} ghost left, Tab begins again / {n} ghosts left, Tab begins again [procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>
    <numerusform>残り {n} 個、Tab で最初から</numerusform>
   </translation>
  </message>
  <message>
   <source>that was the last ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>最後のゴーストでした</translation>
  </message>
  <message>
   <source>that was the first ghost</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>最初のゴーストでした</translation>
  </message>
  <message>
   <source>the camera is being fitted: ghosts come in a moment</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>カメラを当てはめ中です。ゴーストはまもなく現れます</translation>
  </message>
  <message>
   <source>no ghosts: the camera is looked for in the picture</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ゴーストなし：画像からカメラを探しています</translation>
  </message>
  <message>
   <source>no ghosts: no camera is known; {advice}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ゴーストなし：カメラが不明です。{advice}</translation>
  </message>
  <message>
   <source>no ghosts: {why}</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ゴーストなし：{why}</translation>
  </message>
  <message>
   <source>no ghosts: what else is in sight is annotated, or not known well enough</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ゴーストなし：ほかに見えるものは注釈済みか、十分に確かではありません</translation>
  </message>
  <message>
   <source>no ghosts: they are switched off (Element &gt; Ghosts &gt; Show ghosts)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ゴーストなし：オフになっています（要素 &gt; ゴースト &gt; ゴーストを表示）</translation>
  </message>
  <message>
   <source>overlays are hidden: no ghost can be seen (Ctrl+H, or let go of X)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>重ね描きが非表示のため、ゴーストは見えません（Ctrl+H、または X を離す）</translation>
  </message>
  <message>
   <source>finish what is being drawn first (Enter), or cancel it (Esc)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>まず描画中のものを終えるか（Enter）、取り消してください（Esc）</translation>
  </message>
  <message>
   <source>no ghosts: no camera could be fitted</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>ゴーストなし：カメラを当てはめられませんでした</translation>
  </message>
  <message>
   <source>no camera fits yet</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>まだ合うカメラがありません</translation>
  </message>
  <message>
   <source>it is being drawn by hand</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>手で描いている最中です</translation>
  </message>
  <message>
   <source>{title} is annotated here: delete it first (Ctrl+Delete)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} はここで注釈済みです。まず削除してください（Ctrl+Delete）</translation>
  </message>
  <message>
   <source>{title} is not visible here; Ctrl+. takes it back</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} はここでは見えません。Ctrl+. で取り消し</translation>
  </message>
  <message>
   <source>{title} may be visible here again</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{title} はここで再び見える可能性があります</translation>
  </message>
  <message>
   <source>no element of this frame was said to be not visible</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>このフレームで見えないとされた要素はありません</translation>
  </message>
  <message>
   <source>go to a ghost first (Tab)</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>まずゴーストへ移ってください（Tab）</translation>
  </message>
  <message>
   <source>{off}; choose an element first</source>
   <extracomment>[procc_annotator/gui/commands/ghosts.py]</extracomment>
   <translation>{off}。まず要素を選んでください</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported ({format}).</source>
   <extracomment>{edited} of {n:,} frame imported ({format}). / {edited} of {n:,} frames imported ({format}). [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレーム中 {edited} を取り込みました（{format}）。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Cancelled: {n:,} frames were not checked.</source>
   <extracomment>Cancelled: {n:,} frame was not checked. / Cancelled: {n:,} frames were not checked. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>取り消しました：{n:,} フレームは調べていません。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are annotated already and left unchanged.</source>
   <extracomment>{n:,} frame is annotated already and left unchanged. / {n:,} frames are annotated already and left unchanged. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームは注釈済みのため、そのままにしました。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames hold the same already.</source>
   <extracomment>{n:,} frame holds the same already. / {n:,} frames hold the same already. [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームはすでに同じ内容です。</numerusform>
   </translation>
  </message>
  <message>
   <source>import</source>
   <comment>a step</comment>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>取り込み</translation>
  </message>
  <message numerus="yes">
   <source>{edited} of {n:,} frames imported</source>
   <extracomment>{edited} of {n:,} frame imported / {edited} of {n:,} frames imported [procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレーム中 {edited} を取り込みました</numerusform>
   </translation>
  </message>
  <message>
   <source>Cancelled; nothing was imported.</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>取り消しました。何も取り込んでいません。</translation>
  </message>
  <message>
   <source>Left as they were</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>そのままにしたもの</translation>
  </message>
  <message>
   <source>Could not be read</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>読めなかったもの</translation>
  </message>
  <message>
   <source>Without a picture here ({n})</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>ここに画像のないもの（{n}）</translation>
  </message>
  <message>
   <source>Changed or left out</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>変更または除外したもの</translation>
  </message>
  <message>
   <source>it could not be saved: {why}</source>
   <extracomment>[procc_annotator/gui/commands/importing.py]</extracomment>
   <translation>保存できませんでした：{why}</translation>
  </message>
  <message>
   <source>error</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>エラー</translation>
  </message>
  <message>
   <source>warning</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>警告</translation>
  </message>
  <message>
   <source>hint</source>
   <comment>a finding</comment>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>ヒント</translation>
  </message>
  <message>
   <source>finding {place} of {total}, {severity}: {elements}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>指摘 {place} / {total}、{severity}：{elements}</translation>
  </message>
  <message>
   <source>no finding is as sure as the Check panel is set to show</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>検査パネルの設定ほど確かな指摘はありません</translation>
  </message>
  <message numerus="yes">
   <source>relabelled {n} elements</source>
   <extracomment>relabelled {n} element / relabelled {n} elements [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>要素 {n} 個のクラスを変更しました</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>checked {n:,} frames, camera model {model}: {found}</source>
   <extracomment>checked {n:,} frame, camera model {model}: {found} / checked {n:,} frames, camera model {model}: {found} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを検査、カメラモデル {model}：{found}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} checked frames</source>
   <extracomment>{n:,} checked frame / {n:,} checked frames [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>検査済みの {n:,} フレーム</numerusform>
   </translation>
  </message>
  <message>
   <source>{element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} と {other}</translation>
  </message>
  <message>
   <source>the label check is still looking at this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>クラス検査はこのフレームをまだ調べています</translation>
  </message>
  <message>
   <source>the label check has found nothing; check the whole set to look at all frames</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>クラス検査の指摘はありません。すべてのフレームを調べるにはセット全体を検査してください</translation>
  </message>
  <message>
   <source>{done}; Ctrl+Z takes it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{done}。Ctrl+Z で取り消し</translation>
  </message>
  <message>
   <source>removed point {n} of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} の点 {n} を取り除きました</translation>
  </message>
  <message>
   <source>swapped {element} and {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} と {other} を入れ替えました</translation>
  </message>
  <message>
   <source>relabelled {element} to {other}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} を {other} に変更しました</translation>
  </message>
  <message>
   <source>ignored until {elements} changes; the Check panel brings it back</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{elements} が変わるまで無視します。検査パネルで再び表示できます</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked</source>
   <extracomment>{n:,} frame cannot be checked / {n:,} frames cannot be checked [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームは検査できません</numerusform>
   </translation>
  </message>
  <message>
   <source>Export findings</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>指摘を書き出す</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} findings in {frames} to {path}</source>
   <extracomment>exported {n:,} finding in {frames} to {path} / exported {n:,} findings in {frames} to {path} [procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>
    <numerusform>{frames}の指摘 {n:,} 件を {path} に書き出しました</numerusform>
   </translation>
  </message>
  <message>
   <source>the label check has found nothing</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>クラス検査の指摘はありません</translation>
  </message>
  <message>
   <source>the elements have changed since: checked again</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>その後要素が変わったため、検査し直しました</translation>
  </message>
  <message>
   <source>removed point of {element}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>{element} の点を取り除きました</translation>
  </message>
  <message>
   <source>go to a finding first (F10)</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>まず指摘へ移ってください（F10）</translation>
  </message>
  <message>
   <source>stopped checking the set; what was found stays</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>セットの検査を止めました。これまでの指摘は残ります</translation>
  </message>
  <message>
   <source>the label check has found nothing in this frame</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>このフレームにクラス検査の指摘はありません</translation>
  </message>
  <message>
   <source>nothing found</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>指摘なし</translation>
  </message>
  <message>
   <source>no remedy is known: {reason}</source>
   <extracomment>[procc_annotator/gui/commands/label_check.py]</extracomment>
   <translation>対処法がありません：{reason}</translation>
  </message>
  <message>
   <source>cameras opened here before are not opened again: {why}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>以前ここで開いたカメラは開き直しません：{why}</translation>
  </message>
  <message>
   <source>Open a video</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>動画を開く</translation>
  </message>
  <message>
   <source>One frame every</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>取り出す間隔</translation>
  </message>
  <message>
   <source>The first frame of every scene</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>各場面の最初のフレーム</translation>
  </message>
  <message>
   <source>Looks through the whole video for cuts; this takes a while</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>動画全体からカットを探します。しばらくかかります</translation>
  </message>
  <message>
   <source>Field</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, the field american_football, the menus]</extracomment>
   <translation>フィールド</translation>
  </message>
  <message>
   <source>Reading {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>{file} を読み込み中</translation>
  </message>
  <message>
   <source>Looking for cuts in {file}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>{file} のカットを探しています</translation>
  </message>
  <message>
   <source>Pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>画像</translation>
  </message>
  <message>
   <source>Videos</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>動画</translation>
  </message>
  <message>
   <source>Nothing is extracted; “Keep this video frame” writes a picture.</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>フレームの書き出しは行いません。「この動画フレームを残す」で画像になります。</translation>
  </message>
  <message>
   <source>cameras opened here before are not there any more: {paths}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>以前ここで開いたカメラがもうありません：{paths}</translation>
  </message>
  <message>
   <source>this frame is a picture already</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>このフレームはすでに画像です</translation>
  </message>
  <message>
   <source>kept as {path}</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>{path} に保存しました</translation>
  </message>
  <message>
   <source>the sample comes with the source, not here</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/tour.py]</extracomment>
   <translation>サンプルはソースに付属しており、ここにはありません</translation>
  </message>
  <message>
   <source>your own copy, in {folder}; load its cameras from the menu Camera</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>自分用のコピー（{folder}）。カメラはカメラメニューから読み込んでください</translation>
  </message>
  <message>
   <source>Load a folder of cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>カメラのフォルダーを読み込む</translation>
  </message>
  <message>
   <source>Load cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>カメラを読み込む</translation>
  </message>
  <message>
   <source>Cameras</source>
   <extracomment>[procc_annotator/gui/commands/opening.py, procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>カメラ</translation>
  </message>
  <message>
   <source>Open a folder of pictures</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>画像のフォルダーを開く</translation>
  </message>
  <message>
   <source>Open a picture</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>画像を開く</translation>
  </message>
  <message>
   <source>Open a second annotator's folder</source>
   <extracomment>[procc_annotator/gui/commands/opening.py]</extracomment>
   <translation>2 人目の注釈者のフォルダーを開く</translation>
  </message>
  <message>
   <source>{width} x {height} px, without the legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px、凡例を除く</translation>
  </message>
  <message>
   <source>{width} x {height} px, too large: choose a smaller scale or SVG</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{width} x {height} px は大きすぎます。倍率を下げるか SVG を選んでください</translation>
  </message>
  <message>
   <source>PNG: pixels, nothing is lost</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>PNG：ピクセル、劣化なし</translation>
  </message>
  <message>
   <source>JPEG: pixels, small</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>JPEG：ピクセル、小さい</translation>
  </message>
  <message>
   <source>SVG: lines and text stay sharp</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>SVG：線と文字が鮮明なまま</translation>
  </message>
  <message>
   <source>Picture (*{suffix})</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>画像 (*{suffix})</translation>
  </message>
  <message>
   <source>Save overlay picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>重ね描き画像を保存</translation>
  </message>
  <message>
   <source>Px of the result per px of the picture; lines and text grow with it</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>画像の 1 px あたりの出力の px。線と文字も同じ比で大きくなります</translation>
  </message>
  <message>
   <source>Explain colours, dashes and marks below the picture</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>色、破線、記号の意味を画像の下に示します</translation>
  </message>
  <message>
   <source>&amp;Kind</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>種類(&amp;K)</translation>
  </message>
  <message>
   <source>&amp;Scale</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>倍率(&amp;S)</translation>
  </message>
  <message>
   <source>Result</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>結果</translation>
  </message>
  <message>
   <source>&amp;Legend</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>凡例(&amp;L)</translation>
  </message>
  <message>
   <source>writing the overlay picture {path} …</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>重ね描き画像 {path} を書き出しています…</translation>
  </message>
  <message>
   <source>open a picture first</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>まず画像を開いてください</translation>
  </message>
  <message>
   <source>{path}: is the picture itself, choose another name</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>{path}：元の画像そのものです。別の名前を選んでください</translation>
  </message>
  <message>
   <source>overlay picture written to {path}</source>
   <extracomment>[procc_annotator/gui/commands/overlay_saving.py]</extracomment>
   <translation>重ね描き画像を {path} に書き出しました</translation>
  </message>
  <message>
   <source>waiting</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>待機中</translation>
  </message>
  <message>
   <source>begun</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>処理中</translation>
  </message>
  <message>
   <source>done</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>完了</translation>
  </message>
  <message>
   <source>failed</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>失敗</translation>
  </message>
  <message>
   <source>Match</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>試合</translation>
  </message>
  <message>
   <source>Stadium</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>スタジアム</translation>
  </message>
  <message>
   <source>Start</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>開始</translation>
  </message>
  <message>
   <source>State</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>状態</translation>
  </message>
  <message>
   <source>Frames</source>
   <extracomment>[procc_annotator/gui/commands/season.py, procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>フレーム</translation>
  </message>
  <message>
   <source>Tracked</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>追跡済み</translation>
  </message>
  <message>
   <source>On paint</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>塗りとの一致</translation>
  </message>
  <message>
   <source>Failed units</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>失敗した単位</translation>
  </message>
  <message>
   <source>Season</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>シーズン</translation>
  </message>
  <message>
   <source>Search: match, stadium, state</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>検索：試合、スタジアム、状態</translation>
  </message>
  <message>
   <source>Tracked cameras…</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>追跡したカメラ…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} matches</source>
   <extracomment>{n:,} match / {n:,} matches [procc_annotator/gui/commands/season.py]</extracomment>
   <translation>
    <numerusform>{n:,} 試合</numerusform>
   </translation>
  </message>
  <message>
   <source>The folder that track writes to</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>track が書き込むフォルダー</translation>
  </message>
  <message>
   <source>Matches</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>試合</translation>
  </message>
  <message>
   <source>open a season first: a folder in which videos lie, or a list of them</source>
   <extracomment>[procc_annotator/gui/commands/season.py]</extracomment>
   <translation>先にシーズンを開いてください：動画のあるフォルダー、またはその一覧</translation>
  </message>
  <message>
   <source>it is annotated by now</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>すでに注釈されました</translation>
  </message>
  <message>
   <source>it was edited since</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>その後編集されました</translation>
  </message>
  <message>
   <source>no frame to accept: follow the shot first (T)</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>受け入れるフレームがありません。先にショットを追跡してください（T）</translation>
  </message>
  <message>
   <source>the shot is still being followed: wait for its end, or stop it (T), then accept</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>ショットを追跡中です：終わるのを待つか止めて（T）から採用してください</translation>
  </message>
  <message>
   <source>no frame to accept: all that were followed are annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>受け入れるフレームがありません。追跡したフレームはすべて注釈済みです</translation>
  </message>
  <message>
   <source>every frame is annotated</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>すべてのフレームが注釈済みです</translation>
  </message>
  <message>
   <source>blind mode: nothing is accepted that was not clicked</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>ブラインドモード：クリックしていないものは採用しません</translation>
  </message>
  <message numerus="yes">
   <source>all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} frame is doubtful ({why}): look at it; Ctrl+Shift+Enter once more accepts it / all {n:,} frames are doubtful ({why}): look at some; Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームすべてが疑わしいです（{why}）。いくつか確認してください。もう一度 Ctrl+Shift+Enter で受け入れます</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points: {done} of {total} frames  ·  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>線の点を探しています：{total} 中 {done} フレーム  ·  Esc で停止</translation>
  </message>
  <message>
   <source>accept elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>要素を採用</translation>
  </message>
  <message>
   <source>take back accepted elements</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>受け入れた要素を取り消す</translation>
  </message>
  <message numerus="yes">
   <source>annotated {n:,} frames</source>
   <extracomment>annotated {n:,} frame / annotated {n:,} frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームに注釈を付けました</numerusform>
   </translation>
  </message>
  <message>
   <source>Ctrl+Z takes them back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>Ctrl+Z で取り消し</translation>
  </message>
  <message numerus="yes">
   <source>taken back: {n:,} annotated frames</source>
   <extracomment>taken back: {n:,} annotated frame / taken back: {n:,} annotated frames [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>取り消しました：注釈した {n:,} フレーム</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames left: {why}</source>
   <extracomment>{n:,} frame left: {why} / {n:,} frames left: {why} [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを残しました：{why}</numerusform>
   </translation>
  </message>
  <message>
   <source>finding line points …  Esc stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>線の点を探しています …  Esc で停止</translation>
  </message>
  <message>
   <source>no frame was annotated: too little of their lines is seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>注釈したフレームはありません：線がほとんど見えません</translation>
  </message>
  <message>
   <source>no frame was accepted: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>採用したフレームはありません：{why}</translation>
  </message>
  <message>
   <source>nothing was accepted that could be taken back</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>取り消せる採用はありません</translation>
  </message>
  <message>
   <source>taken back: no frame is accepted</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>取り消しました：採用したフレームはありません</translation>
  </message>
  <message>
   <source>no frame was annotated: no camera is sure</source>
   <extracomment>[procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>注釈したフレームはありません：確かなカメラがありません</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames are not sure: Alt+PgDown goes through them, the least sure first</source>
   <extracomment>{n:,} frame is not sure: Alt+PgDown shows it / {n:,} frames are not sure: Alt+PgDown goes through them, the least sure first [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームは確かではありません：Alt+PgDown で不確かな順に見ます</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them</source>
   <extracomment>{n:,} doubtful frame left: Ctrl+Shift+Enter once more accepts it / {n:,} doubtful frames left: Ctrl+Shift+Enter once more accepts them [procc_annotator/gui/commands/shot_accepting.py]</extracomment>
   <translation>
    <numerusform>疑わしい {n:,} フレームを残しました。もう一度 Ctrl+Shift+Enter で受け入れます</numerusform>
   </translation>
  </message>
  <message>
   <source>the camera of this frame is unsure: a sure one is looked for in the shot; look at this one, accept its lines (Shift+Enter), then T follows them</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>このフレームのカメラは不確かです。ショット内で確かなカメラを探しています。このカメラを確認して線を受け入れると（Shift+Enter）、T で追跡します</translation>
  </message>
  <message>
   <source>no frame of the shot has a camera that is sure: accept the lines of one (Shift+Enter), or {advice}; then T follows it</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>ショットに確かなカメラのフレームがありません。1 フレームの線を受け入れるか（Shift+Enter）、{advice}。その後 T で追跡します</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, {doubtful:,} of them doubtful (Alt+PgDown); Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを追跡、うち {doubtful:,} は疑わしい（Alt+PgDown）。Ctrl+Shift+Enter で確かなものを採用</numerusform>
   </translation>
  </message>
  <message>
   <source>following: {done} of {total} frames  ·  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>追跡中：{total} 中 {done} フレーム  ·  T で停止</translation>
  </message>
  <message numerus="yes">
   <source>followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones</source>
   <extracomment>followed {n:,} frame, all of them sure; Ctrl+Shift+Enter accepts the sure ones / followed {n:,} frames, all of them sure; Ctrl+Shift+Enter accepts the sure ones [procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを追跡、すべて確か。Ctrl+Shift+Enter で採用</numerusform>
   </translation>
  </message>
  <message>
   <source>looking for the ends of the shot …  T stops</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>ショットの両端を探しています…  T で停止</translation>
  </message>
  <message>
   <source>the shot could not be followed: {why}</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>ショットを追跡できませんでした：{why}</translation>
  </message>
  <message>
   <source>only a video, or frames that follow one another, can be followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>追跡できるのは動画か、連続するフレームだけです</translation>
  </message>
  <message>
   <source>blind mode: no shot is followed, its cameras would be seen</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>ブラインドモード：カメラが見えてしまうため、ショットは追跡しません</translation>
  </message>
  <message>
   <source>stopped; what was followed so far stays</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>停止しました。これまでの追跡は残ります</translation>
  </message>
  <message>
   <source>stopped; nothing was followed</source>
   <extracomment>[procc_annotator/gui/commands/shot_following.py]</extracomment>
   <translation>停止しました。追跡していません</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to everybody who annotates it. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>解除すると、これに注釈する全員にカメラ、ゴースト、当てはめが表示されます。{author} が解除したことと日時がデータセットに記録されます。</translation>
  </message>
  <message>
   <source>Unlocking shows cameras, ghosts and the fit to you; for others it was not locked. It is recorded with the dataset that {author} unlocked it, and when.</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>解除すると、あなたにカメラ、ゴースト、当てはめが表示されます。ほかの人には固定されていませんでした。{author} が解除したことと日時がデータセットに記録されます。</translation>
  </message>
  <message>
   <source>blind mode leaves out {n} on frames that are not committed</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>ブラインドモードのため、未提出のフレームの {n} 件を除きます</translation>
  </message>
  <message>
   <source>{frame}: no verdict on {source} any more</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{frame}：{source} への判定を取り消しました</translation>
  </message>
  <message>
   <source>Note on the verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>判定へのメモ</translation>
  </message>
  <message>
   <source>What is wrong here:</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>ここでの誤り：</translation>
  </message>
  <message>
   <source>Export verdicts</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>判定を書き出す</translation>
  </message>
  <message>
   <source>blind: no frame that is committed has a verdict</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>ブラインド：提出済みのフレームに判定がありません</translation>
  </message>
  <message>
   <source>no frame has a verdict yet: mark one first</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>まだ判定がありません。まずフレームを判定してください</translation>
  </message>
  <message numerus="yes">
   <source>exported {n:,} verdicts to {path}</source>
   <extracomment>exported {n:,} verdict to {path} / exported {n:,} verdicts to {path} [procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>
    <numerusform>判定 {n:,} 件を {path} に書き出しました</numerusform>
   </translation>
  </message>
  <message>
   <source>mark the frame first: camera wrong, labels wrong or fine</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>まずフレームを判定してください：カメラの誤り、注釈の誤り、または OK</translation>
  </message>
  <message>
   <source>not everything could be saved: the figures are of the last saved state</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>すべては保存できませんでした：数値は最後に保存した状態のものです</translation>
  </message>
  <message>
   <source>{source} follows the clicks: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} はクリックに従います。判定は読み込んだカメラに対するものです</translation>
  </message>
  <message>
   <source>{source} is worked out here: a verdict is on a camera that was loaded</source>
   <extracomment>[procc_annotator/gui/commands/triage.py]</extracomment>
   <translation>{source} はここで計算したものです。判定は読み込んだカメラに対するものです</translation>
  </message>
  <message>
   <source>There is no earlier version of this frame.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>このフレームに以前の版はありません。</translation>
  </message>
  <message>
   <source>Compared with now: {changes}. What differs: {elements}.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>現在との比較：{changes}。異なるもの：{elements}。</translation>
  </message>
  <message>
   <source>cannot be read</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>読めません</translation>
  </message>
  <message>
   <source>empty</source>
   <comment>a version</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>空</translation>
  </message>
  <message>
   <source>as now</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>現在と同じ</translation>
  </message>
  <message>
   <source>other elements</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>要素が異なる</translation>
  </message>
  <message>
   <source>points moved</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>点が移動</translation>
  </message>
  <message>
   <source>This is what the frame holds now.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>フレームの現在の内容です。</translation>
  </message>
  <message>
   <source>Compared with now: the same points in another order of elements.</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>現在との比較：同じ点で、要素の順序が異なります。</translation>
  </message>
  <message>
   <source>restore an earlier version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>以前の版に戻す</translation>
  </message>
  <message>
   <source>Earlier versions</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>以前の版</translation>
  </message>
  <message>
   <source>Restore</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>この版に戻す</translation>
  </message>
  <message>
   <source>%d %b %Y, %H:%M:%S</source>
   <comment>a moment; the month as %b is English, as %m a number</comment>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>%Y/%m/%d %H:%M:%S</translation>
  </message>
  <message>
   <source>{n} more</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>ほか {n} 個</translation>
  </message>
  <message>
   <source>the earlier version is back; undo takes it away again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>以前の版に戻しました。元に戻すで取り消せます</translation>
  </message>
  <message>
   <source>the earlier version is back; what could not be read stays a version</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>以前の版に戻しました。読めなかったものも版として残ります</translation>
  </message>
  <message>
   <source>the frame was changed elsewhere: look at it, then restore again</source>
   <extracomment>[procc_annotator/gui/commands/versions.py]</extracomment>
   <translation>フレームが別の場所で変更されました。確認してからもう一度戻してください</translation>
  </message>
  <message>
   <source>Frames of one instant from different cameras are one group. Their names tell which, by a pattern: &lt;b&gt;{instant}&lt;/b&gt; stands for when a frame was taken, &lt;b&gt;{view}&lt;/b&gt; for the camera, all else for itself. A regular expression with &lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; and &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; does it, too.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>同じ瞬間を別のカメラから写したフレームが 1 つのグループです。名前のパターンで指定します：&lt;b&gt;{instant}&lt;/b&gt; は撮影の瞬間、&lt;b&gt;{view}&lt;/b&gt; はカメラ、それ以外は文字どおりです。&lt;b&gt;(?P&amp;lt;instant&amp;gt;…)&lt;/b&gt; と &lt;b&gt;(?P&amp;lt;view&amp;gt;…)&lt;/b&gt; を含む正規表現も使えます。</translation>
  </message>
  <message>
   <source>No pattern was found that fits these names: write one.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>これらの名前に合うパターンが見つかりません。書いてください。</translation>
  </message>
  <message>
   <source>What it says now is lost, with everything else that is written in it.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>今の内容は、そこに書かれたほかのすべてとともに失われます。</translation>
  </message>
  <message>
   <source>Instant</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>瞬間</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups of {least} to {most}</source>
   <extracomment>{frames} in {n:,} group of {least} to {most} / {frames} in {n:,} groups of {least} to {most} [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames}、{n:,} グループ（各 {least}～{most}）</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} of {n:,} instants</source>
   <extracomment>{frames} of {n:,} instant / {frames} of {n:,} instants [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames}、{n:,} 瞬間</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames, none grouped.</source>
   <extracomment>{n:,} frame, none grouped. / {n:,} frames, none grouped. [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレーム、グループなし。</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} groups</source>
   <extracomment>{frames} in {n:,} group / {frames} in {n:,} groups [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>{frames}、{n:,} グループ</numerusform>
   </translation>
  </message>
  <message>
   <source>This name does not fit the pattern: the frame stands alone</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>この名前はパターンに合わないため、フレームは単独です</translation>
  </message>
  <message>
   <source>{file} groups {sizes} from now on</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>以後 {file} が{sizes}をまとめます</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} instants with one frame only</source>
   <extracomment>{n:,} instant with one frame only / {n:,} instants with one frame only [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>フレームが 1 つだけの瞬間 {n:,}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} names do not fit (last in the table)</source>
   <extracomment>{n:,} name does not fit (last in the table) / {n:,} names do not fit (last in the table) [procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>
    <numerusform>合わない名前 {n:,}（表の末尾）</numerusform>
   </translation>
  </message>
  <message>
   <source>Group views</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>ビューをまとめる</translation>
  </message>
  <message>
   <source>{file} is there already: {sizes}.</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} はすでにあります：{sizes}。</translation>
  </message>
  <message>
   <source>Write {file}</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>{file} に書き込む</translation>
  </message>
  <message>
   <source>Keep these groups in the dataset's folder</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>これらのグループをデータセットのフォルダーに保存します</translation>
  </message>
  <message>
   <source>Groups of frames</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>フレームのグループ</translation>
  </message>
  <message>
   <source>Pattern of the frames' names</source>
   <extracomment>[procc_annotator/gui/commands/view_grouping.py]</extracomment>
   <translation>フレーム名のパターン</translation>
  </message>
  <message numerus="yes">
   <source>{n} elements, symmetries: {turns}</source>
   <extracomment>{n} element, symmetries: {turns} / {n} elements, symmetries: {turns} [procc_annotator/gui/field_preview.py]</extracomment>
   <translation>
    <numerusform>要素 {n} 個、対称：{turns}</numerusform>
   </translation>
  </message>
  <message>
   <source>There is no field to show yet.</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>表示するフィールドがまだありません。</translation>
  </message>
  <message>
   <source>{dimension}: {value:.10g} m (the rules allow {least:g} to {most:g} m)</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>{dimension}：{value:.10g} m（規則では {least:g}～{most:g} m）</translation>
  </message>
  <message>
   <source>... and {n} more</source>
   <extracomment>[procc_annotator/gui/field_preview.py]</extracomment>
   <translation>... ほか {n} 件</translation>
  </message>
  <message>
   <source>none</source>
   <extracomment>[procc_annotator/gui/field_preview.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>なし</translation>
  </message>
  <message>
   <source>what is held down in the picture</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>画像で押し続けるキー</translation>
  </message>
  <message>
   <source>Usual</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>標準</translation>
  </message>
  <message>
   <source>Left-handed</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>左利き</translation>
  </message>
  <message>
   <source>Like CVAT</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>CVAT 風</translation>
  </message>
  <message>
   <source>Like labelme</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>labelme 風</translation>
  </message>
  <message>
   <source>Wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ホイール</translation>
  </message>
  <message>
   <source>zoom at the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>カーソル位置で拡大・縮小</translation>
  </message>
  <message>
   <source>Two fingers</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>2 本指</translation>
  </message>
  <message>
   <source>pan; pinched, zoom</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>移動。つまむと拡大・縮小</translation>
  </message>
  <message>
   <source>Shift + wheel</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Shift + ホイール</translation>
  </message>
  <message>
   <source>pan sideways, as a tilted wheel does</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>チルトホイールのように横へ移動</translation>
  </message>
  <message>
   <source>Space + drag</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Space + ドラッグ</translation>
  </message>
  <message>
   <source>pan</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>移動</translation>
  </message>
  <message>
   <source>Middle button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>中ボタン</translation>
  </message>
  <message>
   <source>Hold X</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>X を押し続ける</translation>
  </message>
  <message>
   <source>hide all overlays</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>重ね描きをすべて隠す</translation>
  </message>
  <message>
   <source>Hold Z</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Z を押し続ける</translation>
  </message>
  <message>
   <source>loupe: eight times the picture's pixels</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ルーペ：画像ピクセルの 8 倍</translation>
  </message>
  <message>
   <source>Hold ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>, を押し続ける</translation>
  </message>
  <message>
   <source>look at the compared camera source</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>比較中のカメラソースを見る</translation>
  </message>
  <message>
   <source>Tap ,</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>, を押す</translation>
  </message>
  <message>
   <source>judge with the compared source, compare with this one</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>比較中のソースで評価し、今のソースと比べる</translation>
  </message>
  <message>
   <source>Hold Ctrl</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl を押し続ける</translation>
  </message>
  <message>
   <source>click off the line: no snapping</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>線の横をクリック：吸着なし</translation>
  </message>
  <message>
   <source>Ctrl+Alt + drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + 線をドラッグ</translation>
  </message>
  <message>
   <source>camera: it follows, the place stays as a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>カメラ：追従し、その場所は杭として残る</translation>
  </message>
  <message>
   <source>Ctrl+Alt + click a peg</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Ctrl+Alt + 杭をクリック</translation>
  </message>
  <message>
   <source>camera: take the peg away</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>カメラ：杭を取り除く</translation>
  </message>
  <message>
   <source>Arrows</source>
   <extracomment>[procc_annotator/gui/keymap.py, procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>矢印キー</translation>
  </message>
  <message>
   <source>crosshair: the keys point; chosen points are moved instead</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>十字カーソル：キーで指す。選んだ点があればそれを動かす</translation>
  </message>
  <message>
   <source>Space at the crosshair</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>十字カーソルで Space</translation>
  </message>
  <message>
   <source>what a click does there (with Ctrl: no snapping)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>そこでのクリックと同じ（Ctrl で吸着なし）</translation>
  </message>
  <message>
   <source>Right button</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>右ボタン</translation>
  </message>
  <message>
   <source>menu of what is under the cursor</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>カーソルの下にあるもののメニュー</translation>
  </message>
  <message>
   <source>Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Enter</translation>
  </message>
  <message>
   <source>accept the current ghost</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>現在のゴーストを採用</translation>
  </message>
  <message>
   <source>Shift+Enter</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Shift+Enter</translation>
  </message>
  <message>
   <source>accept all ghosts</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>すべてのゴーストを採用</translation>
  </message>
  <message>
   <source>Click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>クリック</translation>
  </message>
  <message>
   <source>draw: add a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>描画：点を加える</translation>
  </message>
  <message>
   <source>Double-click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>ダブルクリック</translation>
  </message>
  <message>
   <source>draw: finish</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>描画：終える</translation>
  </message>
  <message>
   <source>Drag a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>点をドラッグ</translation>
  </message>
  <message>
   <source>edit: move it</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>編集：動かす</translation>
  </message>
  <message>
   <source>Shift+click a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>点を Shift+クリック</translation>
  </message>
  <message>
   <source>edit: choose several</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>編集：複数を選ぶ</translation>
  </message>
  <message>
   <source>Drag on empty ground</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>何もない所をドラッグ</translation>
  </message>
  <message>
   <source>edit: choose the points inside</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>編集：中の点を選ぶ</translation>
  </message>
  <message>
   <source>Drag a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>線をドラッグ</translation>
  </message>
  <message>
   <source>edit: move the element, unless elements are pinned</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>編集：要素を動かす（固定中を除く）</translation>
  </message>
  <message>
   <source>Alt+click a line</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>線を Alt+クリック</translation>
  </message>
  <message>
   <source>edit: insert a point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>編集：点を挿入</translation>
  </message>
  <message>
   <source>Alt+Shift+click</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>Alt+Shift+クリック</translation>
  </message>
  <message>
   <source>edit: remove the point</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>編集：点を取り除く</translation>
  </message>
  <message>
   <source>Click or drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>帯をクリックまたはドラッグ</translation>
  </message>
  <message>
   <source>go to a frame</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>フレームへ移る</translation>
  </message>
  <message>
   <source>Wheel on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>帯の上でホイール</translation>
  </message>
  <message>
   <source>zoom; with Shift, scroll</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>拡大・縮小。Shift でスクロール</translation>
  </message>
  <message>
   <source>Shift+drag on the strip</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>帯の上で Shift+ドラッグ</translation>
  </message>
  <message>
   <source>mark a stretch (a double click lets go of it)</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>区間に印を付ける（ダブルクリックで解除）</translation>
  </message>
  <message>
   <source>expected an object with "actions" and "elements"</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" と "elements" を持つオブジェクトが必要です</translation>
  </message>
  <message>
   <source>"actions" and "elements": expected objects</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>"actions" と "elements"：オブジェクトが必要です</translation>
  </message>
  <message>
   <source>{place}: {value!r} is no key; expected one like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}：{value!r} はキーではありません。{one} のように書いてください</translation>
  </message>
  <message>
   <source>{place}: expected a list of keys, like {one}</source>
   <extracomment>[procc_annotator/gui/keymap.py]</extracomment>
   <translation>{place}：{one} のようなキーの一覧が必要です</translation>
  </message>
  <message>
   <source>Panels</source>
   <extracomment>[procc_annotator/gui/main_window.py]</extracomment>
   <translation>パネル</translation>
  </message>
  <message>
   <source>Choose another place…</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>別の場所を選ぶ…</translation>
  </message>
  <message>
   <source>Save copies to…</source>
   <extracomment>[procc_annotator/gui/messages.py, the action save_copies]</extracomment>
   <translation>コピーを保存…</translation>
  </message>
  <message>
   <source>Copy details</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>詳細をコピー</translation>
  </message>
  <message>
   <source>Show the next</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>次を表示</translation>
  </message>
  <message>
   <source>{what} is there already, and says something else.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} はすでにあり、内容が異なります。</translation>
  </message>
  <message numerus="yes">
   <source>{n} comments on this frame are not settled.</source>
   <extracomment>{n} comment on this frame is not settled. / {n} comments on this frame are not settled. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>このフレームに未解決のコメントが {n} 件あります。</numerusform>
   </translation>
  </message>
  <message>
   <source>A tick in the Review panel settles a comment.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>「レビュー」パネルでチェックを入れるとコメントは解決済みになります。</translation>
  </message>
  <message>
   <source>{n:,} of {total:,} frames are not done.</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{total:,} フレーム中 {n:,} が未完了です。</translation>
  </message>
  <message numerus="yes">
   <source>{n} frames are not saved, and saving failed again just now.</source>
   <extracomment>{n} frame is not saved, and saving failed again just now. / {n} frames are not saved, and saving failed again just now. [procc_annotator/gui/messages.py]</extracomment>
   <translation>
    <numerusform>{n} フレームが保存されておらず、今また保存に失敗しました。</numerusform>
   </translation>
  </message>
  <message>
   <source>Show what is in the file; undo brings your version back</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>ファイルの内容を表示します。元に戻すと自分の版に戻ります</translation>
  </message>
  <message>
   <source>Write what you see on screen over the file</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>画面の内容をファイルに上書きします</translation>
  </message>
  <message>
   <source>Export all</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>すべて書き出す</translation>
  </message>
  <message>
   <source>Done only</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>完了のみ</translation>
  </message>
  <message>
   <source>Dismiss this message</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>このメッセージを閉じる</translation>
  </message>
  <message>
   <source>Reload theirs</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>相手の内容を読み込む</translation>
  </message>
  <message>
   <source>Overwrite with mine</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>自分の内容で上書き</translation>
  </message>
  <message>
   <source>Delete {what}?</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>{what} を削除しますか？</translation>
  </message>
  <message>
   <source>Keep it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>そのまま残す</translation>
  </message>
  <message>
   <source>Delete</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>削除</translation>
  </message>
  <message>
   <source>Replace it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>置き換える</translation>
  </message>
  <message>
   <source>Do not approve</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>承認しない</translation>
  </message>
  <message>
   <source>Approve</source>
   <extracomment>[procc_annotator/gui/messages.py, procc_annotator/gui/panels/review.py, the action approve]</extracomment>
   <translation>承認</translation>
  </message>
  <message>
   <source>Keep it locked</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>固定したままにする</translation>
  </message>
  <message>
   <source>Unlock, and record it</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>解除して記録する</translation>
  </message>
  <message>
   <source>Stay</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>とどまる</translation>
  </message>
  <message>
   <source>Close and lose them</source>
   <extracomment>[procc_annotator/gui/messages.py]</extracomment>
   <translation>閉じて失う</translation>
  </message>
  <message>
   <source>Open a second annotator's folder (menu File) to compare the clicks of both.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>2 人目の注釈者のフォルダーを開くと（ファイルメニュー）、両者のクリックを比較します。</translation>
  </message>
  <message>
   <source>Apart: the two share (almost) no stretch of this element, which is no agreement. Was its class swapped with a neighbour's?</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>別々：この要素で両者が共有する区間が（ほとんど）なく、一致とは言えません。隣のクラスと取り違えていませんか？</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks compared</source>
   <extracomment>{n:,} click compared / {n:,} clicks compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} クリックを比較</numerusform>
   </translation>
  </message>
  <message>
   <source>{part} of {total}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>{total} 中 {part}</translation>
  </message>
  <message>
   <source>apart</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>別々</translation>
  </message>
  <message numerus="yes">
   <source>{compared}, {n} left out: beyond the ends of what the other clicked</source>
   <extracomment>{compared}, {n} left out: beyond the ends of what the other clicked / {compared}, {n} left out: beyond the ends of what the other clicked [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{compared}、{n} を除外：相手がクリックした範囲の外</numerusform>
   </translation>
  </message>
  <message>
   <source>Measuring the set…</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>セットを測定中…</translation>
  </message>
  <message>
   <source>Distances by element</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>要素ごとの距離</translation>
  </message>
  <message>
   <source>Close the second annotator</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>2 人目の注釈を閉じます</translation>
  </message>
  <message>
   <source>The second annotator's file for this frame is unreadable: {error}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>このフレームの 2 人目の注釈ファイルを読めません：{error}</translation>
  </message>
  <message>
   <source>Agreement JaC at {tau:g} px: {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>一致度 JaC（{tau:g} px）：{jac:.3f}</translation>
  </message>
  <message>
   <source>No element is annotated by both in any frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>両者がともに注釈した要素のあるフレームがありません。</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames unreadable, not compared</source>
   <extracomment>{n:,} frame unreadable, not compared / {n:,} frames unreadable, not compared [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームは読めず、比較していません</numerusform>
   </translation>
  </message>
  <message>
   <source>Median</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>中央値</translation>
  </message>
  <message>
   <source>Points</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>点</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows the score once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>非表示：ブラインドモードでは、このフレームの提出後にスコアを表示します。</translation>
  </message>
  <message>
   <source>One of the two seems to label the field turned by 180 degrees.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>一方がフィールドを 180 度回転させてクラスを付けているようです。</translation>
  </message>
  <message>
   <source>Apart: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>別々：{elements}</translation>
  </message>
  <message>
   <source>Only here: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>こちらだけ：{elements}</translation>
  </message>
  <message>
   <source>Only there: {elements}</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>相手だけ：{elements}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} clicks beyond the other's ends, left out</source>
   <extracomment>{n:,} click beyond the other's ends, left out / {n:,} clicks beyond the other's ends, left out [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>相手の端を越える {n:,} クリックを除外</numerusform>
   </translation>
  </message>
  <message>
   <source>Nothing to measure noise by: all elements annotated by both are apart.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>ばらつきを測れません：両者が注釈した要素がすべて別々です。</translation>
  </message>
  <message numerus="yes">
   <source>Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height})</source>
   <extracomment>Human noise over {n:,} frame: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) / Human noise over {n:,} frames: median {median:.2f} px, 95 % within {p95:.2f} px (at {width}x{height}) [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームでの人によるばらつき：中央値 {median:.2f} px、95 % が {p95:.2f} px 以内（{width}x{height} で）</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>and {n} more</source>
   <extracomment>and {n} more / and {n} more [procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>
    <numerusform>ほか {n} 件</numerusform>
   </translation>
  </message>
  <message>
   <source>The second annotator has nothing for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/agreement.py]</extracomment>
   <translation>このフレームには 2 人目の注釈がありません。</translation>
  </message>
  <message>
   <source>Frames of this dataset that have a camera (completeness)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>このデータセットでカメラのあるフレーム（網羅率）</translation>
  </message>
  <message>
   <source>Frames visited in this window whose clicks gave a camera; their JaC is of the clicks that the fit was made from.
procc-annotator calibrate fits and scores the whole set</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>このウィンドウで開き、クリックからカメラが求まったフレーム。JaC は当てはめに使ったクリック自身に対する値です。
procc-annotator calibrate はセット全体を当てはめて採点します</translation>
  </message>
  <message>
   <source>Frames of this dataset that were followed through their shot and have a camera.
procc-annotator track follows a whole video and writes its cameras</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ショット内で追跡し、カメラのあるこのデータセットのフレーム。
procc-annotator track は動画全体を追跡してカメラを書き出します</translation>
  </message>
  <message>
   <source>Yellow</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>黄</translation>
  </message>
  <message>
   <source>Violet</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>紫</translation>
  </message>
  <message>
   <source>Blue</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>青</translation>
  </message>
  <message>
   <source>Mint</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ミント</translation>
  </message>
  <message>
   <source>Navy</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>紺</translation>
  </message>
  <message>
   <source>Cyan</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>シアン</translation>
  </message>
  <message>
   <source>Switch the live fit off (Ctrl+T switches it on again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>自動当てはめをオフにする（Ctrl+T で再びオン）</translation>
  </message>
  <message>
   <source>Name of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ソースの名前</translation>
  </message>
  <message>
   <source>Draw as a wireframe while another source is judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>別のソースを評価している間、ワイヤーフレームで描きます</translation>
  </message>
  <message>
   <source>Mean JaC at {tau:.1f} px over {frames}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>平均 JaC（{tau:.1f} px、{frames}）</translation>
  </message>
  <message>
   <source>Unreadable (filter camera:unreadable): {names}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>読めないもの（フィルター camera:unreadable）：{names}</translation>
  </message>
  <message numerus="yes">
   <source>{matched} of {total}, {n} unreadable</source>
   <extracomment>{matched} of {total}, {n} unreadable / {matched} of {total}, {n} unreadable [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{total} 中 {matched}、{n} は読めません</numerusform>
   </translation>
  </message>
  <message>
   <source>Remove from the list; the files stay</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>一覧から除く（ファイルは残ります）</translation>
  </message>
  <message>
   <source>Forget what was followed (T follows the shot again)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>追跡結果を破棄する（T で再び追跡）</translation>
  </message>
  <message>
   <source>Judge nothing, draw no camera</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>何も評価せず、カメラも描きません</translation>
  </message>
  <message>
   <source>Judge against {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} を評価</translation>
  </message>
  <message>
   <source>Remove {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} を除く</translation>
  </message>
  <message>
   <source>Draw {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} を描く</translation>
  </message>
  <message>
   <source>Colour of {name}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{name} の色</translation>
  </message>
  <message>
   <source>{frames} so far</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>これまでの {frames}</translation>
  </message>
  <message numerus="yes">
   <source>{mean}; {n:,} cameras cannot be read and take no part</source>
   <extracomment>{mean}; {n:,} camera cannot be read and takes no part / {mean}; {n:,} cameras cannot be read and take no part [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{mean}。{n:,} 個のカメラは読めず、対象外です</numerusform>
   </translation>
  </message>
  <message>
   <source>{model} (ground)</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{model}（地面）</translation>
  </message>
  <message>
   <source>{model} here</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ここでは {model}</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames followed</source>
   <extracomment>{n:,} frame followed / {n:,} frames followed [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを追跡</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} opened frames</source>
   <extracomment>{n:,} opened frame / {n:,} opened frames [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>開いた {n:,} フレーム</numerusform>
   </translation>
  </message>
  <message>
   <source>{n} of {total} ({share})</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>{total} 中 {n}（{share}）</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n:,} more</source>
   <extracomment>{names} and {n:,} more / {names} and {n:,} more [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{names} ほか {n:,} 件</numerusform>
   </translation>
  </message>
  <message>
   <source>cannot be used here: {error}</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ここでは使えません：{error}</translation>
  </message>
  <message>
   <source>no camera for this frame</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>このフレームのカメラがありません</translation>
  </message>
  <message>
   <source>Other…</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>その他…</translation>
  </message>
  <message>
   <source>Colour of the source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ソースの色</translation>
  </message>
  <message>
   <source>Double-click or F2 gives it another name</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ダブルクリックまたは F2 で名前を変えられます</translation>
  </message>
  <message>
   <source>Blind mode hides how the sources do</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>ブラインドモードではソースの良し悪しを隠します</translation>
  </message>
  <message>
   <source>No frame has both annotated elements and a camera of this source</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>注釈された要素とこのソースのカメラがともにあるフレームがありません</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} cameras</source>
   <extracomment>{n:,} camera / {n:,} cameras [procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>
    <numerusform>{n:,} 個のカメラ</numerusform>
   </translation>
  </message>
  <message>
   <source>none judged</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>評価しない</translation>
  </message>
  <message>
   <source>several models</source>
   <extracomment>[procc_annotator/gui/panels/camera_sources.py]</extracomment>
   <translation>複数のモデル</translation>
  </message>
  <message>
   <source>soccernet (official)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the setting protocol]</extracomment>
   <translation>soccernet（公式）</translation>
  </message>
  <message>
   <source>procc (paper)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>procc（論文）</translation>
  </message>
  <message>
   <source>count as missed</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>見逃しとして数える</translation>
  </message>
  <message>
   <source>are left out</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>数えない</translation>
  </message>
  <message>
   <source>Cameras ({endings});;All files (*)</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>カメラ ({endings});;すべてのファイル (*)</translation>
  </message>
  <message>
   <source>Source to compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>比較するソース</translation>
  </message>
  <message>
   <source>Compare with</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>比較対象</translation>
  </message>
  <message>
   <source>{share:.0f} % within {far:g} m, over {covered:.0f} % of the picture</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>{far:g} m 以内 {share:.0f} %（画像の {covered:.0f} %）</translation>
  </message>
  <message>
   <source>No cameras loaded.
Load a folder of camera files or homographies to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>カメラが読み込まれていません。
カメラファイルまたはホモグラフィのフォルダーを読み込むと、クリックと照らして評価します。</translation>
  </message>
  <message>
   <source>Load folder…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>フォルダーを読み込む…</translation>
  </message>
  <message>
   <source>Load file…</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>ファイルを読み込む…</translation>
  </message>
  <message>
   <source>Read as</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>読み方</translation>
  </message>
  <message>
   <source>Protocol</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py, the menus, the setting protocol]</extracomment>
   <translation>プロトコル</translation>
  </message>
  <message>
   <source>Off the ground</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>地面にない要素</translation>
  </message>
  <message>
   <source>This frame: {notice}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>このフレーム：{notice}</translation>
  </message>
  <message>
   <source>⚠ This frame's camera cannot be used: {error}</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>⚠ このフレームのカメラは使えません：{error}</translation>
  </message>
  <message>
   <source>Held against the active source: comma, split view, disagreement</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>使用中のソースと照らし合わせます：コンマ、分割表示、不一致</translation>
  </message>
  <message>
   <source>min</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>最小</translation>
  </message>
  <message>
   <source>median</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>中央値</translation>
  </message>
  <message>
   <source>max</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>最大</translation>
  </message>
  <message>
   <source>on the ground, m</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>地面上、m</translation>
  </message>
  <message>
   <source>in the picture, px</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>画像内、px</translation>
  </message>
  <message>
   <source>A folder with one camera file a frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>フレームごとに 1 つのカメラファイルがあるフォルダー</translation>
  </message>
  <message>
   <source>A zip archive of cameras, or the camera of one frame</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>カメラの zip、または 1 フレームのカメラ</translation>
  </message>
  <message>
   <source>How the files loaded next are read</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>次に読み込むファイルの読み方</translation>
  </message>
  <message>
   <source>soccernet: the official evaluation with its quirks
procc: the paper's definition, closed circles and fine curves</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>soccernet：公式評価（その癖も含む）
procc：論文の定義。閉じた円と細かい曲線</translation>
  </message>
  <message>
   <source>A homography knows the ground only: how posts and crossbars count for it</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>ホモグラフィは地面しか知りません。ポストやクロスバーの数え方を決めます</translation>
  </message>
  <message>
   <source>Between the two points on the ground that a pixel means</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>1 ピクセルが指す地面上の 2 点の間</translation>
  </message>
  <message>
   <source>From a pixel to where the compared camera shows its ground point</source>
   <extracomment>[procc_annotator/gui/panels/cameras.py]</extracomment>
   <translation>ピクセルから、その地面の点を比較カメラが示す位置まで</translation>
  </message>
  <message>
   <source>annotated</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py, procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>注釈済み</translation>
  </message>
  <message>
   <source>unconfirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>未確定</translation>
  </message>
  <message>
   <source>not visible</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>見えない</translation>
  </message>
  <message>
   <source>next</source>
   <comment>element</comment>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>次</translation>
  </message>
  <message>
   <source>Not annotated in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>このフレームでは注釈なし</translation>
  </message>
  <message>
   <source>Annotated, but not judged: no camera is shown, or it takes no part in the evaluation</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>注釈済みだが評価なし：カメラが表示されていないか、評価の対象外</translation>
  </message>
  <message>
   <source>Copied; it does not count until it is touched or confirmed</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>コピーしたもの。触れるか確定するまで数えません</translation>
  </message>
  <message>
   <source>Passes: all its points are closer than tau to the projection</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>合格：すべての点が投影から tau より近い</translation>
  </message>
  <message>
   <source>Too far: at least one point is tau or more away (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>遠すぎる：少なくとも 1 点が tau 以上離れている（偽陽性）</translation>
  </message>
  <message>
   <source>The camera projects it, it is not annotated (false positive)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>カメラは投影するが注釈なし（偽陽性）</translation>
  </message>
  <message>
   <source>Annotated, the camera does not project it (false negative)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>注釈済みだがカメラは投影しない（偽陰性）</translation>
  </message>
  <message>
   <source>Marked as not visible in this frame</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>このフレームでは見えないとされたもの</translation>
  </message>
  <message>
   <source>To be annotated next, as on the field map and in the picture</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>次に注釈するもの（フィールド図と画像に示すとおり）</translation>
  </message>
  <message>
   <source>{title} (unknown class)</source>
   <extracomment>[procc_annotator/gui/panels/element_states.py]</extracomment>
   <translation>{title}（未知のクラス）</translation>
  </message>
  <message>
   <source>Without geometry</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>形状なし</translation>
  </message>
  <message>
   <source>Unknown to the field (unknown classes)</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>フィールドにない（未知のクラス）</translation>
  </message>
  <message>
   <source>Find an element</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>要素を探す</translation>
  </message>
  <message>
   <source>No element matches “{query}”.
Esc clears the search.</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>「{query}」に一致する要素はありません。
Esc で検索を消します。</translation>
  </message>
  <message>
   <source>Annotated points</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>注釈された点</translation>
  </message>
  <message>
   <source>{title}
Class in files: {name}</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>{title}
ファイル内のクラス：{name}</translation>
  </message>
  <message>
   <source>Elements</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>要素</translation>
  </message>
  <message>
   <source>Key</source>
   <comment>keyboard</comment>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>キー</translation>
  </message>
  <message>
   <source>Pts</source>
   <extracomment>[procc_annotator/gui/panels/elements.py]</extracomment>
   <translation>点</translation>
  </message>
  <message>
   <source>Status</source>
   <extracomment>[procc_annotator/gui/panels/elements.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>状態</translation>
  </message>
  <message>
   <source>Annotating it next helps most: the projection is then known to {after:.1f} px instead of {before:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>次にこれを注釈すると最も効果があります：投影の不確かさが {before:.1f} px から {after:.1f} px になります</translation>
  </message>
  <message>
   <source>Field map</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>フィールド図</translation>
  </message>
  <message>
   <source>The arrows choose elements</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>矢印キーで要素を選びます</translation>
  </message>
  <message>
   <source>far</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>奥</translation>
  </message>
  <message>
   <source>right</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>右</translation>
  </message>
  <message>
   <source>near</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>手前</translation>
  </message>
  <message>
   <source>left</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>左</translation>
  </message>
  <message>
   <source>Next: {title}, {before:.1f} → {after:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>次：{title}、{before:.1f} → {after:.1f} px</translation>
  </message>
  <message>
   <source>Click an element</source>
   <extracomment>[procc_annotator/gui/panels/field_map/field_map_panel.py]</extracomment>
   <translation>要素をクリック</translation>
  </message>
  <message>
   <source>{shown:,} of {frames}</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py, procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>{frames} 中 {shown:,}</translation>
  </message>
  <message>
   <source>Show all frames</source>
   <extracomment>[procc_annotator/gui/panels/film_strip.py]</extracomment>
   <translation>すべてのフレームを表示</translation>
  </message>
  <message>
   <source>Error</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>エラー</translation>
  </message>
  <message>
   <source>Warning</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>警告</translation>
  </message>
  <message>
   <source>Hint</source>
   <extracomment>[procc_annotator/gui/panels/finding_rows.py]</extracomment>
   <translation>ヒント</translation>
  </message>
  <message>
   <source>Nothing found in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>このフレームに指摘はありません。</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found in {n:,} frames.</source>
   <extracomment>Nothing found in {n:,} frame. / Nothing found in {n:,} frames. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームに指摘はありません。</numerusform>
   </translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures to check their labels.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>フレームがありません。
画像のフォルダーを開くとクラスを検査します。</translation>
  </message>
  <message>
   <source>Nothing is annotated in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>このフレームには何も注釈されていません。</translation>
  </message>
  <message>
   <source>No problems so far.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>今のところ問題はありません。</translation>
  </message>
  <message numerus="yes">
   <source>Nothing found but {n:,} ignored findings.</source>
   <extracomment>Nothing found but {n:,} ignored finding. / Nothing found but {n:,} ignored findings. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>無視した {n:,} 件のほかに指摘はありません。</numerusform>
   </translation>
  </message>
  <message>
   <source>Blind: findings that need a camera wait until this frame is committed (Ctrl+Enter).</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>ブラインド：カメラの要る指摘は、このフレームを提出するまで出ません（Ctrl+Enter）。</translation>
  </message>
  <message>
   <source>The live fit is off: the full check needs it.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>自動当てはめがオフです：完全な検査にはこれが必要です。</translation>
  </message>
  <message>
   <source>Full check needs a camera: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>完全な検査にはカメラが必要です：{why}。</translation>
  </message>
  <message>
   <source>Blind: only committed frames are checked with a camera.</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>ブラインド：カメラを使う検査は提出済みのフレームだけです。</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} frames cannot be checked, such as {name}: {why}</source>
   <extracomment>{n:,} frame cannot be checked, such as {name}: {why} / {n:,} frames cannot be checked, such as {name}: {why} [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>{n:,} フレームを検査できません。例：{name}：{why}</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>The set is not checked yet; {n:,} frames checked so far.</source>
   <extracomment>The set is not checked yet; {n:,} frame checked so far. / The set is not checked yet; {n:,} frames checked so far. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>セットはまだ検査していません。これまでに {n:,} フレームを調べました。</numerusform>
   </translation>
  </message>
  <message>
   <source>List the findings of all checked frames, errors first, or of this frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>検査した全フレームの指摘（エラーが先）、またはこのフレームの指摘を表示します</translation>
  </message>
  <message>
   <source>Frames checked</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>検査したフレーム</translation>
  </message>
  <message>
   <source>Checking this frame…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>このフレームを検査中…</translation>
  </message>
  <message>
   <source>Checking the set…</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>セットを検査中…</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} errors</source>
   <extracomment>{n:,} error / {n:,} errors [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>エラー {n:,} 件</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} warnings</source>
   <extracomment>{n:,} warning / {n:,} warnings [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>警告 {n:,} 件</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{n:,} hints</source>
   <extracomment>{n:,} hint / {n:,} hints [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>ヒント {n:,} 件</numerusform>
   </translation>
  </message>
  <message>
   <source>Check the whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>セット全体を検査</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} more are not listed: switch the signs above on.</source>
   <extracomment>{n:,} more is not listed: switch the signs above on. / {n:,} more are not listed: switch the signs above on. [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>ほかに {n:,} 件を表示していません。上の記号をオンにしてください。</numerusform>
   </translation>
  </message>
  <message>
   <source>Do not show it again until the points of its elements change</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action ignore_finding]</extracomment>
   <translation>その要素の点が変わるまで表示しません</translation>
  </message>
  <message>
   <source>Findings</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>指摘</translation>
  </message>
  <message>
   <source>Whole set</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>セット全体</translation>
  </message>
  <message>
   <source>Look for wrong labels in every annotated frame</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, the action check_set]</extracomment>
   <translation>注釈のある全フレームで誤ったクラスを探します</translation>
  </message>
  <message>
   <source>Write the findings of all checked frames as CSV</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>検査した全フレームの指摘を CSV に書き出します</translation>
  </message>
  <message>
   <source>{findings}; click to list them or not</source>
   <extracomment>[procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>{findings}。クリックで表示・非表示</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt;</source>
   <extracomment>{n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; / {n:,} ignored here. &lt;a href="restore"&gt;Show again&lt;/a&gt; [procc_annotator/gui/panels/findings.py]</extracomment>
   <translation>
    <numerusform>ここで {n:,} 件を無視。&lt;a href="restore"&gt;再び表示&lt;/a&gt;</numerusform>
   </translation>
  </message>
  <message>
   <source>Ignore this finding</source>
   <extracomment>[procc_annotator/gui/panels/findings.py, procc_annotator/gui/window/menus.py, the action ignore_finding]</extracomment>
   <translation>この指摘を無視</translation>
  </message>
  <message>
   <source>Mean</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>平均</translation>
  </message>
  <message>
   <source>Largest</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>最大</translation>
  </message>
  <message>
   <source>Worst first; a click shows the worst point</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>悪い順。クリックで最悪の点を表示します</translation>
  </message>
  <message>
   <source>Mean distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>当てはめた要素までの点の平均距離、画像の px</translation>
  </message>
  <message>
   <source>Largest distance of its points to the fitted element, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>当てはめた要素までの点の最大距離、画像の px</translation>
  </message>
  <message>
   <source>{model}. Chosen: {why}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{model}。選択理由：{why}</translation>
  </message>
  <message numerus="yes">
   <source>{passing} of {n:,} annotated elements within {px:g} px</source>
   <extracomment>{passing} of {n:,} annotated element within {px:g} px / {passing} of {n:,} annotated elements within {px:g} px [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>注釈済み {n:,} 要素中 {passing} が {px:g} px 以内</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>{counted}; {n} in sight not annotated yet</source>
   <extracomment>{counted}; {n} in sight not annotated yet / {counted}; {n} in sight not annotated yet [procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>
    <numerusform>{counted}。見えるが未注釈 {n}</numerusform>
   </translation>
  </message>
  <message>
   <source>{title}: mean {mean} px, largest {largest} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>{title}：平均 {mean} px、最大 {largest} px</translation>
  </message>
  <message>
   <source>Taken for a mistake: it had no say in the fit</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>誤りとみなされ、当てはめに使われませんでした</translation>
  </message>
  <message>
   <source>Elements in sight that are not annotated count against the JaC</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>見えているのに注釈のない要素は JaC を下げます</translation>
  </message>
  <message>
   <source>Hardly determined: {limits}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>ほぼ決まらないもの：{limits}</translation>
  </message>
  <message>
   <source>Mean distance of the points that had a say, px of the picture</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>当てはめに使われた点の平均距離、画像の px</translation>
  </message>
  <message>
   <source>Standard deviation, as the fit estimates it</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>当てはめが推定した標準偏差</translation>
  </message>
  <message>
   <source>Save as the frame's camera</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>フレームのカメラとして保存</translation>
  </message>
  <message>
   <source>✕ left out: {title}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>✕ 除外：{title}</translation>
  </message>
  <message>
   <source>Pan</source>
   <comment>an angle</comment>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>パン</translation>
  </message>
  <message>
   <source>Tilt</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>チルト</translation>
  </message>
  <message>
   <source>Roll</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>ロール</translation>
  </message>
  <message>
   <source>Focal length</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>焦点距離</translation>
  </message>
  <message>
   <source>Along (x)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>縦方向 (x)</translation>
  </message>
  <message>
   <source>Across (y)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>横方向 (y)</translation>
  </message>
  <message>
   <source>Height (−z)</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>高さ (−z)</translation>
  </message>
  <message>
   <source>Model</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>モデル</translation>
  </message>
  <message>
   <source>Residuals by element</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>要素ごとの残差</translation>
  </message>
  <message>
   <source>No camera yet: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>まだカメラがありません：{why}。</translation>
  </message>
  <message>
   <source>Fitting the clicks…</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>クリックに当てはめ中…</translation>
  </message>
  <message>
   <source>No fit.</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>当てはめがありません。</translation>
  </message>
  <message>
   <source>JaC at {tau:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/fit.py, procc_annotator/gui/panels/plots/pages.py, procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC（{tau:.1f} px）</translation>
  </message>
  <message>
   <source>&lt;b&gt;Hardly determined&lt;/b&gt;: {what}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>&lt;b&gt;ほぼ決まらないもの&lt;/b&gt;：{what}</translation>
  </message>
  <message>
   <source>JaC: {terms}; residuals: px of the picture, {width}x{height}</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>JaC：{terms}。残差：画像の px、{width}x{height}</translation>
  </message>
  <message>
   <source>What is fitted. Automatically: the simplest model that the clicks support</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>当てはめるモデル。自動：クリックが支える最も単純なもの</translation>
  </message>
  <message>
   <source>mean residual</source>
   <extracomment>[procc_annotator/gui/panels/fit.py]</extracomment>
   <translation>平均残差</translation>
  </message>
  <message numerus="yes">
   <source>{n} open</source>
   <extracomment>{n} open / {n} open [procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>
    <numerusform>未解決 {n}</numerusform>
   </translation>
  </message>
  <message>
   <source>all done</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>すべて完了</translation>
  </message>
  <message>
   <source>not annotated</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>注釈なし</translation>
  </message>
  <message>
   <source>⚠ unreadable</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ 読めません</translation>
  </message>
  <message>
   <source>⚠ camera</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>⚠ カメラ</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} done</source>
   <extracomment>{n:,} done / {n:,} done [procc_annotator/gui/panels/frame_delegate.py, procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>
    <numerusform>完了 {n:,}</numerusform>
   </translation>
  </message>
  <message>
   <source>● not saved</source>
   <extracomment>[procc_annotator/gui/panels/frame_delegate.py]</extracomment>
   <translation>● 未保存</translation>
  </message>
  <message>
   <source>the picture cannot be read</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>画像を読めません</translation>
  </message>
  <message>
   <source>mean JaC {jac:.3f}</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>平均 JaC {jac:.3f}</translation>
  </message>
  <message>
   <source>folded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>折りたたみ</translation>
  </message>
  <message>
   <source>unfolded</source>
   <extracomment>[procc_annotator/gui/panels/frame_rows.py]</extracomment>
   <translation>展開</translation>
  </message>
  <message>
   <source>Filter frames</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>フレームを絞り込む</translation>
  </message>
  <message>
   <source>No frames.
Open a folder of pictures (jpg, png, bmp, webp), or drop one here.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>フレームがありません。
画像（jpg、png、bmp、webp）のフォルダーを開くか、ここにドロップしてください。</translation>
  </message>
  <message>
   <source>Nothing matches “{query}”.</source>
   <extracomment>[procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>「{query}」に一致するものはありません。</translation>
  </message>
  <message numerus="yes">
   <source>{frames} in {n:,} folders</source>
   <extracomment>{frames} in {n:,} folder / {frames} in {n:,} folders [procc_annotator/gui/panels/frames.py]</extracomment>
   <translation>
    <numerusform>{frames}、{n:,} フォルダー</numerusform>
   </translation>
  </message>
  <message>
   <source>No landmarks. A landmark is a place of this stadium that the field does not have: a seat, the corner of a board, a floodlight. Name one below, and click it in two calibrated views.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>目印がありません。目印とは、フィールドにないこのスタジアムの場所です：座席、看板の角、照明など。下で名前を付け、校正済みの 2 つのビューでクリックしてください。</translation>
  </message>
  <message>
   <source>Find its place from the views it is clicked in; cameras are those of the active source, else fits to the clicks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>クリックされたビューから位置を求めます。カメラは使用中のソース、なければクリックへの当てはめを使います</translation>
  </message>
  <message>
   <source>Other views of this instant</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>この瞬間の別のビュー</translation>
  </message>
  <message>
   <source>No other views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>別のビューなし</translation>
  </message>
  <message>
   <source>Its place cannot be brought back with undo. Clicks on it stay in the annotations.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>位置は元に戻すで復元できません。クリックは注釈に残ります。</translation>
  </message>
  <message>
   <source>Landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>目印</translation>
  </message>
  <message>
   <source>Views</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>ビュー</translation>
  </message>
  <message>
   <source>Triangulated from {frames}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{frames} から三角測量</translation>
  </message>
  <message>
   <source>Other views of this instant: go to one with a click</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>この瞬間の別のビュー：クリックで移ります</translation>
  </message>
  <message>
   <source>{title} is clicked in no frame yet: click it in two calibrated views to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} はまだどのフレームでもクリックされていません。校正済みの 2 つのビューでクリックすると三角測量します。</translation>
  </message>
  <message>
   <source>Clicked here, but no landmarks yet: {names}. Write a name next to Add to triangulate it.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>ここでクリックされたがまだ目印でないもの：{names}。「追加」の横に名前を書くと三角測量します。</translation>
  </message>
  <message>
   <source>Its place is not known yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>位置はまだ分かりません</translation>
  </message>
  <message>
   <source>Surveyed</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>測量済み</translation>
  </message>
  <message>
   <source>New landmark</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>新しい目印</translation>
  </message>
  <message>
   <source>Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/panels/review.py, procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>追加</translation>
  </message>
  <message>
   <source>What people call it</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>通称</translation>
  </message>
  <message>
   <source>x, y, z in metres, z down</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>x、y、z（メートル、z は下向き）</translation>
  </message>
  <message>
   <source>Set</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>設定</translation>
  </message>
  <message>
   <source>Triangulate</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>三角測量</translation>
  </message>
  <message>
   <source>Standard deviation in the direction where it is largest</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>最も大きい方向の標準偏差</translation>
  </message>
  <message>
   <source>{name} is being triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{name} を三角測量中です。</translation>
  </message>
  <message>
   <source>{why}. Delete the landmark and name it again to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{why}。目印を削除し、名前を付け直すと三角測量します。</translation>
  </message>
  <message>
   <source>Looking for the frames in which {title} is clicked…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} がクリックされたフレームを探しています…</translation>
  </message>
  <message>
   <source>{title} is clicked in {frame} alone: click it in another calibrated view to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>{title} は {frame} でしかクリックされていません。校正済みの別のビューでもクリックすると三角測量します。</translation>
  </message>
  <message>
   <source>Choose a landmark in the list to have it triangulated.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>一覧で目印を選ぶと三角測量します。</translation>
  </message>
  <message>
   <source>Only a landmark that has a name can be triangulated: write one next to Add.</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>三角測量できるのは名前のある目印だけです。「追加」の横に書いてください。</translation>
  </message>
  <message numerus="yes">
   <source>{names} and {n} more</source>
   <extracomment>{names} and {n} more / {names} and {n} more [procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>
    <numerusform>{names} ほか {n} 件</numerusform>
   </translation>
  </message>
  <message>
   <source>Landmarks</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py, procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>目印</translation>
  </message>
  <message>
   <source>Have a new landmark, to be clicked (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>クリックする目印を新しく作ります（Enter）</translation>
  </message>
  <message>
   <source>The place was measured: it stays as it is from now on (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>位置は測量値です。以後この値のままにします（Enter）</translation>
  </message>
  <message>
   <source>Forget this landmark; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>この目印を削除します。クリックは注釈に残ります</translation>
  </message>
  <message>
   <source>Title</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>名称</translation>
  </message>
  <message>
   <source>Place</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>位置</translation>
  </message>
  <message>
   <source>Not clicked in any frame yet</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>まだどのフレームでもクリックされていません</translation>
  </message>
  <message>
   <source>Triangulating…</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>三角測量中…</translation>
  </message>
  <message>
   <source>a landmark needs a name: write one next to Add</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>目印には名前が必要です。「追加」の横に書いてください</translation>
  </message>
  <message>
   <source>deleted the landmark {title}; clicks on it stay in the annotations</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>目印 {title} を削除しました。クリックは注釈に残ります</translation>
  </message>
  <message>
   <source>the landmark {title}</source>
   <extracomment>[procc_annotator/gui/panels/landmarks.py]</extracomment>
   <translation>目印 {title}</translation>
  </message>
  <message>
   <source>Picture (*.png);;Vector graphics (*.svg)</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>画像 (*.png);;ベクター画像 (*.svg)</translation>
  </message>
  <message>
   <source>the plotted numbers are on the clipboard</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>グラフの数値をクリップボードにコピーしました</translation>
  </message>
  <message>
   <source>Save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>グラフを保存</translation>
  </message>
  <message>
   <source>wrote {path}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} を書き出しました（採点済みの分まで）</translation>
  </message>
  <message>
   <source>wrote {path}</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{path} を書き出しました</translation>
  </message>
  <message>
   <source>the plot is on the clipboard as a picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>グラフを画像としてクリップボードにコピーしました</translation>
  </message>
  <message>
   <source>there is nothing plotted to take along</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>持ち出せるグラフがありません</translation>
  </message>
  <message>
   <source>{frames}, as far as scored</source>
   <extracomment>[procc_annotator/gui/panels/plots/export.py]</extracomment>
   <translation>{frames}、採点済みの分まで</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows committed frames only, and none of them is in this plot.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>非表示：ブラインドモードでは提出済みのフレームだけを示し、このグラフには 1 つもありません。</translation>
  </message>
  <message>
   <source>Hidden: blind mode shows this plot once this frame is committed.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>非表示：ブラインドモードでは、このフレームの提出後にこのグラフを表示します。</translation>
  </message>
  <message>
   <source>Sources: {names}</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>ソース：{names}</translation>
  </message>
  <message>
   <source>Shots are recognized by names, since {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/page.py]</extracomment>
   <translation>ショットは名前で区別しています：{error}。</translation>
  </message>
  <message>
   <source>JaC over tau</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau に対する JaC</translation>
  </message>
  <message>
   <source>JaC over the frames</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>フレームごとの JaC</translation>
  </message>
  <message>
   <source>No scores yet. They are computed in the background, frame by frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>スコアはまだありません。バックグラウンドでフレームごとに計算します。</translation>
  </message>
  <message>
   <source>Errors, as a histogram</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>誤差のヒストグラム</translation>
  </message>
  <message numerus="yes">
   <source>{n:,} points without a distance left out.</source>
   <extracomment>{n:,} point without a distance left out. / {n:,} points without a distance left out. [procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>
    <numerusform>距離のない {n:,} 点を除外。</numerusform>
   </translation>
  </message>
  <message>
   <source>Residuals over the picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>画像上の残差</translation>
  </message>
  <message>
   <source>tau (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau (px)</translation>
  </message>
  <message>
   <source>frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>フレーム</translation>
  </message>
  <message>
   <source>{name} (frame {n})</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name}（フレーム {n}）</translation>
  </message>
  <message>
   <source>No score of this frame: it is not annotated, or no shown source has its camera.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>このフレームのスコアはありません：注釈がないか、表示中のどのソースにもカメラがありません。</translation>
  </message>
  <message>
   <source>reprojection error (px)</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>再投影誤差 (px)</translation>
  </message>
  <message>
   <source>points</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>点の数</translation>
  </message>
  <message>
   <source>How many times longer than they are arrows are drawn</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>矢印を実際の何倍の長さで描くか</translation>
  </message>
  <message>
   <source>Arrows drawn longer</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>矢印の拡大</translation>
  </message>
  <message>
   <source>The last bar holds all larger errors.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>最後の棒はそれより大きい誤差のすべてです。</translation>
  </message>
  <message>
   <source>{px:g} px or more</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{px:g} px 以上</translation>
  </message>
  <message>
   <source>{name} {part:,} of {total:,}</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{name} {part:,} / {total:,}</translation>
  </message>
  <message>
   <source>No point of {element} in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>このフレームに {element} の点はありません。</translation>
  </message>
  <message>
   <source>No point of {element} so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>{element} の点はまだありません。</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects in this frame.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>このフレームには、表示中のソースが投影する注釈点がありません。</translation>
  </message>
  <message>
   <source>No annotated point that a shown source projects so far.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>表示中のソースが投影する注釈点はまだありません。</translation>
  </message>
  <message>
   <source>automatic</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>自動</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: from the click towards the projection.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>矢印は実際の {factor} 倍の長さ：クリックから投影へ。</translation>
  </message>
  <message>
   <source>Arrows {factor} times as long as they are: the median residual of each part of the picture with 5 points or more.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>矢印は実際の {factor} 倍の長さ：5 点以上ある画像の各区画の残差の中央値。</translation>
  </message>
  <message>
   <source>Each curve is the mean of the frames that source has a camera for.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>各曲線は、そのソースにカメラのあるフレームの平均です。</translation>
  </message>
  <message>
   <source>Shaded: 95 % bands, {drawn}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>網掛け：95 % の帯、{drawn}。</translation>
  </message>
  <message>
   <source>tau {px:.1f} px</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>tau {px:.1f} px</translation>
  </message>
  <message>
   <source>Too few points so far: five in a part of the picture make an arrow.</source>
   <extracomment>[procc_annotator/gui/panels/plots/pages.py]</extracomment>
   <translation>点がまだ足りません：画像の 1 区画に 5 点で矢印になります。</translation>
  </message>
  <message>
   <source>This frame</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>このフレーム</translation>
  </message>
  <message>
   <source>Copy or save the plot and its numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>グラフとその数値をコピーまたは保存します</translation>
  </message>
  <message>
   <source>Plot the points of one element only</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>1 つの要素の点だけをグラフにします</translation>
  </message>
  <message>
   <source>({n:,} of {total:,})</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（{n:,} / {total:,}）</translation>
  </message>
  <message>
   <source>All elements</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>すべての要素</translation>
  </message>
  <message>
   <source>Plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>グラフ</translation>
  </message>
  <message>
   <source>This plot could not be computed: {error}.</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>このグラフは計算できませんでした：{error}。</translation>
  </message>
  <message>
   <source>({n:,} committed)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（提出済み {n:,}）</translation>
  </message>
  <message>
   <source>Copy or save the plot</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>グラフをコピーまたは保存</translation>
  </message>
  <message>
   <source>Copy picture</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>画像をコピー</translation>
  </message>
  <message>
   <source>Copy numbers</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>数値をコピー</translation>
  </message>
  <message>
   <source>Save picture…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>画像を保存…</translation>
  </message>
  <message>
   <source>Save numbers…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>数値を保存…</translation>
  </message>
  <message>
   <source>Plot the frame on screen, or all frames scored so far</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>表示中のフレーム、またはこれまでに採点した全フレームをグラフにします</translation>
  </message>
  <message>
   <source>Computing…</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>計算中…</translation>
  </message>
  <message>
   <source>(hidden)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（非表示）</translation>
  </message>
  <message>
   <source>(no score)</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>（スコアなし）</translation>
  </message>
  <message>
   <source>Save</source>
   <extracomment>[procc_annotator/gui/panels/plots/plots_panel.py]</extracomment>
   <translation>保存</translation>
  </message>
  <message>
   <source>Committed in blind mode, and as it was then.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>ブラインドモードで提出され、そのままです。</translation>
  </message>
  <message>
   <source>Edited after the cameras were shown.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>カメラの表示後に編集されました。</translation>
  </message>
  <message>
   <source>{seconds} s</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{seconds} 秒</translation>
  </message>
  <message>
   <source>How the points of this frame came to be</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>このフレームの点の由来</translation>
  </message>
  <message>
   <source>Add the comment to the thread (Enter)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>スレッドにコメントを加えます（Enter）</translation>
  </message>
  <message>
   <source>Committed in blind mode by {author}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{author} がブラインドモードで提出</translation>
  </message>
  <message>
   <source>{minutes}:{seconds:02d} min</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{minutes}:{seconds:02d} 分</translation>
  </message>
  <message>
   <source>This frame is right (Ctrl+Shift+A)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>このフレームは正しい（Ctrl+Shift+A）</translation>
  </message>
  <message>
   <source>Send it back (Ctrl+Shift+X)</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>差し戻す（Ctrl+Shift+X）</translation>
  </message>
  <message>
   <source>Reject</source>
   <extracomment>[procc_annotator/gui/panels/review.py, the action reject]</extracomment>
   <translation>差し戻し</translation>
  </message>
  <message>
   <source>No comments on this frame.</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>このフレームにコメントはありません。</translation>
  </message>
  <message>
   <source>Comment on this place</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>この場所へのコメント</translation>
  </message>
  <message>
   <source>{frame} is {status}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>{frame} は{status}です</translation>
  </message>
  <message>
   <source>{frame} is {status} again</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} は再び{status}です</translation>
  </message>
  <message>
   <source>Time worked on this frame; pauses over 30 s do not count</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>このフレームの作業時間。30 秒を超える休止は数えません</translation>
  </message>
  <message>
   <source>Comments</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>コメント</translation>
  </message>
  <message>
   <source>Points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>点：{kinds}</translation>
  </message>
  <message>
   <source>Points: none</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>点：なし</translation>
  </message>
  <message numerus="yes">
   <source>to be confirmed (Shift+V): {n:,} elements</source>
   <extracomment>to be confirmed (Shift+V): {n:,} element / to be confirmed (Shift+V): {n:,} elements [procc_annotator/gui/panels/review.py]</extracomment>
   <translation>
    <numerusform>確定待ち（Shift+V）：要素 {n:,} 個</numerusform>
   </translation>
  </message>
  <message>
   <source>Comment on this frame</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>このフレームへのコメント</translation>
  </message>
  <message>
   <source>Ticked: settled</source>
   <extracomment>[procc_annotator/gui/panels/review.py]</extracomment>
   <translation>チェック：解決済み</translation>
  </message>
  <message>
   <source>somebody</source>
   <extracomment>[procc_annotator/gui/panels/review.py, procc_annotator/gui/state/editing/batch_edits.py, procc_annotator/gui/state/state.py]</extracomment>
   <translation>誰か</translation>
  </message>
  <message>
   <source>Choose an element to read why it counts as it does.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>要素を選ぶと、なぜそう数えるかが読めます。</translation>
  </message>
  <message>
   <source>the camera is the fit to these same clicks: this JaC is no score of a method</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>カメラはこれらのクリック自身への当てはめです。この JaC は手法のスコアではありません</translation>
  </message>
  <message>
   <source>Mirrored labels count here: the field turned by 180° fits at least as well.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>鏡像のクラスで数えています：180° 回転したフィールドが同等以上に合います。</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>人によるばらつき：中央値 {median:.2f} px、95 % が {p95:.2f} px 以内</translation>
  </message>
  <message>
   <source>human noise {median:.2f} px, 95 % within {p95:.2f} px – more than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>人によるばらつき：中央値 {median:.2f} px、95 % が {p95:.2f} px 以内 – tau より大</translation>
  </message>
  <message>
   <source>Point</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>点</translation>
  </message>
  <message>
   <source>Worst</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>最悪</translation>
  </message>
  <message>
   <source>Passes at</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>合格 tau</translation>
  </message>
  <message>
   <source>Click a row to see the point that decides</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>行をクリックすると決め手の点を表示します</translation>
  </message>
  <message>
   <source>How the element counts at tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>この tau での要素の数え方</translation>
  </message>
  <message>
   <source>The point that decides, counted from 1</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>決め手の点（1 から数えて）</translation>
  </message>
  <message>
   <source>Largest distance of its points to the projection, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>投影までの点の最大距離、px</translation>
  </message>
  <message>
   <source>The smallest tau of the slider at which it passes, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>合格となるスライダーの最小の tau、px</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>カメラの誤り</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <comment>a verdict</comment>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>注釈の誤り</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>このフレームでは使用中のカメラが誤り</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>このフレームではクリックが誤り</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>このフレームではカメラもクリックも正しい</translation>
  </message>
  <message>
   <source>What causes the score of this frame; saved with the dataset</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>このフレームのスコアが低いのはどちらのせいか。データセットに保存されます</translation>
  </message>
  <message>
   <source>Precision</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>適合率</translation>
  </message>
  <message>
   <source>Recall</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>再現率</translation>
  </message>
  <message>
   <source>Mean error</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>平均誤差</translation>
  </message>
  <message>
   <source>Mean reprojection error of all points, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>全点の再投影誤差の平均、px</translation>
  </message>
  <message>
   <source>Median reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>再投影誤差の中央値、px</translation>
  </message>
  <message>
   <source>Max</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>最大</translation>
  </message>
  <message>
   <source>Largest reprojection error, px</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>再投影誤差の最大、px</translation>
  </message>
  <message>
   <source>{name} has no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{name} にはこのフレームのカメラがありません。</translation>
  </message>
  <message>
   <source>points: {kinds}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>点：{kinds}</translation>
  </message>
  <message>
   <source>{verdict}; once more takes it back ({key})</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{verdict}。もう一度で取り消し（{key}）</translation>
  </message>
  <message>
   <source>Verdict: {verdict}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>判定：{verdict}</translation>
  </message>
  <message>
   <source>Scores by element</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>要素ごとのスコア</translation>
  </message>
  <message>
   <source>Copy this explanation</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>この説明をコピー</translation>
  </message>
  <message>
   <source>Copy all explanations</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>すべての説明をコピー</translation>
  </message>
  <message>
   <source>JaC –: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>JaC –：{why}。</translation>
  </message>
  <message>
   <source>This frame's camera cannot be used:
{error}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>このフレームのカメラは使えません：
{error}</translation>
  </message>
  <message>
   <source>No fit to judge: {why}.</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>評価する当てはめがありません：{why}。</translation>
  </message>
  <message>
   <source>Counts as {class_name}</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>{class_name} として数える</translation>
  </message>
  <message>
   <source>Verdict</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>判定</translation>
  </message>
  <message>
   <source>Elements whose points all are closer than tau</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>すべての点が tau より近い要素</translation>
  </message>
  <message>
   <source>Elements too far, or projected and not annotated</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>遠すぎる要素、または投影されたが注釈のない要素</translation>
  </message>
  <message>
   <source>Annotated elements that the camera does not project</source>
   <extracomment>[procc_annotator/gui/panels/scores.py]</extracomment>
   <translation>注釈されたがカメラが投影しない要素</translation>
  </message>
  <message>
   <source>anchor</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>アンカー</translation>
  </message>
  <message>
   <source>followed</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>追跡</translation>
  </message>
  <message>
   <source>bridged</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>補間</translation>
  </message>
  <message>
   <source>lost</source>
   <comment>a frame</comment>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>見失い</translation>
  </message>
  <message>
   <source>frame {number} of {first}–{last}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>フレーム {number}（{first}～{last}）</translation>
  </message>
  <message>
   <source>{state}, {share:.0%} of the lines on paint</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{state}、線の {share:.0%} が塗りの上</translation>
  </message>
  <message>
   <source>names count by {step}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>名前の番号は {step} ずつ増えます</translation>
  </message>
  <message>
   <source>its camera was dragged</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>カメラを動かしました</translation>
  </message>
  <message>
   <source>blind: its camera is hidden</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>ブラインド：カメラは非表示</translation>
  </message>
  <message>
   <source>{found}, {far:.1f} px from it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>{found}、ずれ {far:.1f} px</translation>
  </message>
  <message>
   <source>doubtful: {why}</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>疑わしい：{why}</translation>
  </message>
  <message>
   <source>Frames of the shot</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>ショットのフレーム</translation>
  </message>
  <message>
   <source>The arrows go from frame to frame, with Shift they mark a stretch, Esc forgets it</source>
   <extracomment>[procc_annotator/gui/panels/timeline/shot_strip.py]</extracomment>
   <translation>矢印キーでフレームを移動、Shift で区間に印、Esc で解除</translation>
  </message>
  <message>
   <source>not {number:g}: {least:g} to {most:g}{unit}</source>
   <extracomment>[procc_annotator/gui/panels/widgets.py]</extracomment>
   <translation>{number:g} は不可: {least:g}～{most:g}{unit}</translation>
  </message>
  <message>
   <source>Fit and ghosts</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting fit_model, the setting ghost_support]</extracomment>
   <translation>当てはめとゴースト</translation>
  </message>
  <message>
   <source>Annotating</source>
   <extracomment>[procc_annotator/gui/settings.py, the setting author, the setting auto_advance]</extracomment>
   <translation>注釈</translation>
  </message>
  <message>
   <source>blind: the camera is hidden until this frame is committed (Ctrl+Enter)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>ブラインド：このフレームを提出するまでカメラは非表示です（Ctrl+Enter）</translation>
  </message>
  <message>
   <source>load cameras first: there is nothing to score</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>まずカメラを読み込んでください：採点するものがありません</translation>
  </message>
  <message>
   <source>open a folder of pictures first</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>まず画像のフォルダーを開いてください</translation>
  </message>
  <message>
   <source>choose the camera to judge first (C)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>まず評価するカメラを選んでください（C）</translation>
  </message>
  <message>
   <source>the live fit is off (Ctrl+T)</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>自動当てはめはオフです（Ctrl+T）</translation>
  </message>
  <message>
   <source>{text}.</source>
   <extracomment>[procc_annotator/gui/state/availability.py]</extracomment>
   <translation>{text}。</translation>
  </message>
  <message>
   <source>unexpected error ({what})</source>
   <extracomment>[procc_annotator/gui/state/background.py]</extracomment>
   <translation>予期しないエラー ({what})</translation>
  </message>
  <message>
   <source>expected files like camera_00037.json, 00037.npy or 00037.homographyMatrix</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>camera_00037.json、00037.npy、00037.homographyMatrix のようなファイルが必要です</translation>
  </message>
  <message>
   <source>load one of its folders: {names}</source>
   <extracomment>[procc_annotator/gui/state/camera_sources.py]</extracomment>
   <translation>その中のフォルダーを 1 つ読み込んでください：{names}</translation>
  </message>
  <message>
   <source>it holds the same already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>すでに同じ内容です</translation>
  </message>
  <message>
   <source>it is annotated already</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>すでに注釈済みです</translation>
  </message>
  <message>
   <source>{who} is editing it</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>{who} が編集中です</translation>
  </message>
  <message>
   <source>it cannot be edited</source>
   <extracomment>[procc_annotator/gui/state/editing/batch_edits.py]</extracomment>
   <translation>編集できません</translation>
  </message>
  <message>
   <source>blind: nothing is annotated here; Ctrl+Enter again shows the cameras, and what is clicked after that is no blind work</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>ブラインド：ここには注釈がありません。もう一度 Ctrl+Enter を押すとカメラを表示し、その後のクリックはブラインド作業になりません</translation>
  </message>
  <message>
   <source>{frame} is done</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} は完了です</translation>
  </message>
  <message>
   <source>nothing to undo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>このフレームには元に戻す操作がありません</translation>
  </message>
  <message>
   <source>undo once more takes that away</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>もう一度元に戻すとそれも取り消します</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere and read again: {so}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} は別の場所で変更され、読み直しました：{so}</translation>
  </message>
  <message>
   <source>unconfirmed elements do not count: {count}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>未確定の要素は数えません：{count}</translation>
  </message>
  <message>
   <source>undone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>元に戻しました：{step}</translation>
  </message>
  <message>
   <source>redone: {step}</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>やり直しました：{step}</translation>
  </message>
  <message>
   <source>{frame} was changed elsewhere: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>{frame} は別の場所で変更されました：読み直しました</translation>
  </message>
  <message>
   <source>nothing is undone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>何も元に戻していません</translation>
  </message>
  <message>
   <source>nothing is redone</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>何もやり直していません</translation>
  </message>
  <message>
   <source>nothing to redo on this frame</source>
   <extracomment>[procc_annotator/gui/state/editing/editor.py]</extracomment>
   <translation>このフレームにはやり直す操作がありません</translation>
  </message>
  <message>
   <source>cameras of {name} changed: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>{name} のカメラが変わりました：{why}</translation>
  </message>
  <message>
   <source>cameras of {name} changed on disk: read again</source>
   <extracomment>[procc_annotator/gui/state/editing/outside_changes.py]</extracomment>
   <translation>{name} のカメラがディスク上で変わったため、読み直しました</translation>
  </message>
  <message>
   <source>not saved: {why}</source>
   <extracomment>[procc_annotator/gui/state/editing/saving.py]</extracomment>
   <translation>保存されていません：{why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks stay as they were: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>データセットの目印は変わりません：{why}</translation>
  </message>
  <message>
   <source>{title} is at {place} m, ± {deviations}, from {views} views</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} の位置は {place} m、± {deviations}、{views} ビューから</translation>
  </message>
  <message>
   <source>{title} was deleted meanwhile: its place was not kept</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>{title} はその間に削除されたため、位置は保存していません</translation>
  </message>
  <message>
   <source>left out: {names}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>除外：{names}</translation>
  </message>
  <message>
   <source>the dataset's landmarks are not used: {why}</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>データセットの目印は使われません：{why}</translation>
  </message>
  <message>
   <source>the dataset's landmarks can be used again</source>
   <extracomment>[procc_annotator/gui/state/landmarks.py]</extracomment>
   <translation>データセットの目印が再び使えます</translation>
  </message>
  <message>
   <source>{names} share only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names} は要素の見える位置だけを共有し、カメラがありません：比較する地面がありません。</translation>
  </message>
  <message>
   <source>{names}: no camera for this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{names}：このフレームのカメラがありません。</translation>
  </message>
  <message>
   <source>{name} shares only where the elements are shown, no camera: there is no ground to compare.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{name} は要素の見える位置だけを共有し、カメラがありません：比較する地面がありません。</translation>
  </message>
  <message>
   <source>{a} and {b}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>{a} と {b}</translation>
  </message>
  <message>
   <source>The two see no part of the field in common in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>このフレームでは、2 つのカメラに共通して見えるフィールドの部分がありません。</translation>
  </message>
  <message>
   <source>Both cameras are the same in this frame.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>このフレームでは 2 つのカメラが同じです。</translation>
  </message>
  <message>
   <source>No source is judged: choose one first.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>評価するソースがありません。まず 1 つ選んでください。</translation>
  </message>
  <message>
   <source>Two sources of cameras are needed: load another one.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>カメラのソースが 2 つ必要です。もう 1 つ読み込んでください。</translation>
  </message>
  <message>
   <source>The fitted camera sees no part of the field.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>当てはめたカメラにはフィールドが写っていません。</translation>
  </message>
  <message>
   <source>There is no fit of this frame, so no uncertainty map.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>このフレームの当てはめがないため、不確かさの地図はありません。</translation>
  </message>
  <message>
   <source>No camera yet, so no uncertainty map: {why}.</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>まだカメラがないため、不確かさの地図はありません：{why}。</translation>
  </message>
  <message>
   <source>the painted width cannot be drawn: {why}</source>
   <extracomment>[procc_annotator/gui/state/maps.py]</extracomment>
   <translation>塗りの幅を描けません：{why}</translation>
  </message>
  <message>
   <source>{file} says what the field of this dataset is: to choose another one, move that file away and open the dataset again</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>このデータセットのフィールドは {file} が決めています。別のものを選ぶには、そのファイルを移してデータセットを開き直してください</translation>
  </message>
  <message>
   <source>field: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>フィールド：{field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>以後このデータセットのフィールド：{field}</translation>
  </message>
  <message>
   <source>this dataset's field from now on, {reach}: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>以後このデータセットのフィールド（{reach}）：{field}</translation>
  </message>
  <message>
   <source>no other field knows the classes here better</source>
   <extracomment>[procc_annotator/gui/state/navigation/field_choice.py]</extracomment>
   <translation>ここのクラスにこれ以上合うフィールドはありません</translation>
  </message>
  <message>
   <source>{folder} cannot be written: what is annotated here has to be saved elsewhere (File &gt; Save copies to…)</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>{folder} に書き込めません：ここでの注釈は別の場所に保存してください（ファイル &gt; コピーを保存…）</translation>
  </message>
  <message>
   <source>not everything is saved yet: the other dataset was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>まだすべては保存されていません：別のデータセットは開きませんでした</translation>
  </message>
  <message>
   <source>not everything is saved yet: the video was not opened</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>まだすべては保存されていません：動画は開きませんでした</translation>
  </message>
  <message>
   <source>nothing is open</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>何も開いていません</translation>
  </message>
  <message>
   <source>unfinished elements were kept: {titles}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>描きかけの要素を保持しました：{titles}</translation>
  </message>
  <message>
   <source>the field of this dataset: {field}</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>このデータセットのフィールド：{field}</translation>
  </message>
  <message>
   <source>the filter shows no further frame this way</source>
   <extracomment>[procc_annotator/gui/state/navigation/navigator.py]</extracomment>
   <translation>この方向にフィルターに合うフレームはもうありません</translation>
  </message>
  <message>
   <source>you rejected it (Ctrl+Z takes that back)</source>
   <extracomment>[procc_annotator/gui/state/prediction/camera_choice.py]</extracomment>
   <translation>却下しました（Ctrl+Z で取り消し）</translation>
  </message>
  <message>
   <source>draw 3 elements, two of which meet, such as {names}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>交わる 2 つを含む 3 つの要素を描いてください（例：{names}）</translation>
  </message>
  <message>
   <source>{title}: its line could not be looked for: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/ghosts.py]</extracomment>
   <translation>{title}：線を探せませんでした：{why}</translation>
  </message>
  <message>
   <source>chosen automatically</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>自動で選択</translation>
  </message>
  <message>
   <source>H: homography of the ground</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>H：地面のホモグラフィ</translation>
  </message>
  <message>
   <source>P: pinhole</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>P：ピンホール</translation>
  </message>
  <message>
   <source>R: pinhole, lens distortion</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R：ピンホール、レンズ歪み</translation>
  </message>
  <message>
   <source>R+: R, aspect ratio, principal point</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R+：R、アスペクト比、主点</translation>
  </message>
  <message>
   <source>R2: R+, second radial coefficient</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>R2：R+、2 次の放射歪み係数</translation>
  </message>
  <message>
   <source>F: fisheye</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py, the setting fit_model]</extracomment>
   <translation>F：魚眼</translation>
  </message>
  <message>
   <source>the fit failed: {why}</source>
   <extracomment>[procc_annotator/gui/state/prediction/live_fit.py]</extracomment>
   <translation>当てはめに失敗しました：{why}</translation>
  </message>
  <message>
   <source>{who} unlocked this dataset from blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} が {day} にこのデータセットのブラインドモード固定を解除しました</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} は{status}でしたが、作業中に戻りました</translation>
  </message>
  <message>
   <source>for you alone: the dataset's folder cannot be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>自分だけに有効：データセットのフォルダーに書き込めません</translation>
  </message>
  <message>
   <source>{reason}: there is no live fit in it</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}：自動当てはめはありません</translation>
  </message>
  <message>
   <source>This dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>このデータセットはブラインドモードに固定されています</translation>
  </message>
  <message>
   <source>Somebody</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>誰か</translation>
  </message>
  <message>
   <source>{who} locked this dataset to blind mode on {day}</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{who} が {day} にこのデータセットをブラインドモードに固定しました</translation>
  </message>
  <message>
   <source>{frame} was {status} and is in progress again: edited after the cameras were shown, it is no blind work any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{frame} は{status}でしたが、作業中に戻りました：カメラの表示後に編集したため、ブラインド作業ではなくなりました</translation>
  </message>
  <message>
   <source>in this window only: nothing can be written</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>このウィンドウだけ：何も書き込めません</translation>
  </message>
  <message>
   <source>this dataset is not locked to blind mode any more</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>このデータセットのブラインドモードの固定は解除されました</translation>
  </message>
  <message>
   <source>{reason}: menu Frame unlocks it, which is recorded</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>{reason}：フレームメニューで解除できます（記録されます）</translation>
  </message>
  <message>
   <source>this dataset is locked to blind mode</source>
   <extracomment>[procc_annotator/gui/state/review_state.py]</extracomment>
   <translation>このデータセットはブラインドモードに固定されています</translation>
  </message>
  <message>
   <source>{path}: no camera has the name of a frame (cameras are named like {camera!r}, frames like {frame!r})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}：フレームの名前を持つカメラがありません（カメラは {camera!r}、フレームは {frame!r} のような名前です）</translation>
  </message>
  <message>
   <source>{path}: no cameras in it ({what_to_do})</source>
   <extracomment>[procc_annotator/gui/state/scoring/commands.py]</extracomment>
   <translation>{path}：カメラがありません（{what_to_do}）</translation>
  </message>
  <message numerus="yes">
   <source>no class of this field: {n} labels ({names})</source>
   <extracomment>no class of this field: {n} label ({names}) / no class of this field: {n} labels ({names}) [procc_annotator/gui/state/second.py]</extracomment>
   <translation>
    <numerusform>このフィールドにないクラス：{n} 個（{names}）</numerusform>
   </translation>
  </message>
  <message>
   <source>{path}: holds no annotation (*.json)</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>{path}：注釈 (*.json) がありません</translation>
  </message>
  <message>
   <source>second annotator: {why}</source>
   <extracomment>[procc_annotator/gui/state/second.py]</extracomment>
   <translation>2 人目の注釈：{why}</translation>
  </message>
  <message>
   <source>{who} is editing it; it opens by itself once they leave it</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{who} が編集中です。離れると自動で開きます</translation>
  </message>
  <message>
   <source>nothing annotated yet</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>まだ何も注釈されていません</translation>
  </message>
  <message>
   <source>{who} on {machine}</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>{machine} の {who}</translation>
  </message>
  <message>
   <source>annotation cannot be read</source>
   <extracomment>[procc_annotator/gui/state/state.py]</extracomment>
   <translation>注釈を読めません</translation>
  </message>
  <message>
   <source>Enter runs it · ↑ ↓ choose · Esc closes</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>Enter で実行 · ↑ ↓ で選択 · Esc で閉じる</translation>
  </message>
  <message>
   <source>Panel</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>パネル</translation>
  </message>
  <message>
   <source>Setting</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>設定</translation>
  </message>
  <message>
   <source>Open</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>開く</translation>
  </message>
  <message>
   <source>An action, element, frame, camera source, folder, number</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>操作、要素、フレーム、カメラソース、フォルダー、数値</translation>
  </message>
  <message>
   <source>Find anything</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>何でも探す</translation>
  </message>
  <message>
   <source>Nothing is called “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>「{text}」という名前のものはありません。</translation>
  </message>
  <message>
   <source>Threshold {px:g} px</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>しきい値 {px:g} px</translation>
  </message>
  <message>
   <source>Frame {number} of {count}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>フレーム {number} / {count}</translation>
  </message>
  <message>
   <source>Go to this frame</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>このフレームへ移る</translation>
  </message>
  <message>
   <source>Judge elements by this tau</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>この tau で要素を評価します</translation>
  </message>
  <message>
   <source>What fits</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>一致するもの</translation>
  </message>
  <message>
   <source>Judge {source}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>{source} を評価</translation>
  </message>
  <message>
   <source>Judge with this source</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>このソースで評価します</translation>
  </message>
  <message>
   <source>Live fit: model {model}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>自動当てはめ：モデル {model}</translation>
  </message>
  <message>
   <source>Panel {title}</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>パネル {title}</translation>
  </message>
  <message>
   <source>Open this panel and bring it to the front</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py]</extracomment>
   <translation>このパネルを開いて手前に出します</translation>
  </message>
  <message>
   <source>on</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>オン</translation>
  </message>
  <message>
   <source>off</source>
   <extracomment>[procc_annotator/gui/window/command_palette.py, procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>オフ</translation>
  </message>
  <message>
   <source>User guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action guide]</extracomment>
   <translation>ユーザーガイド</translation>
  </message>
  <message>
   <source>Find words in this page</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>このページ内を検索</translation>
  </message>
  <message>
   <source>The user guide is in English.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ユーザーガイドは英語です。</translation>
  </message>
  <message>
   <source>this installation came without its user guide</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>このインストールにはユーザーガイドが含まれていません</translation>
  </message>
  <message>
   <source>About ProCC Annotator</source>
   <extracomment>[procc_annotator/gui/window/commands.py, the action about]</extracomment>
   <translation>ProCC Annotator について</translation>
  </message>
  <message>
   <source>ProCC Annotator {version}
Annotate and audit sports-camera calibrations.</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>ProCC Annotator {version}
ProCC プロトコルによるスポーツカメラ校正の注釈と監査。</translation>
  </message>
  <message>
   <source>Headings</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>見出し</translation>
  </message>
  <message>
   <source>no cameras are loaded (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>カメラが読み込まれていません（Ctrl+L）</translation>
  </message>
  <message>
   <source>load a second set of cameras to see side by side (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>並べて見るには 2 つ目のカメラセットを読み込んでください（Ctrl+L）</translation>
  </message>
  <message>
   <source>load a second set of cameras to compare (Ctrl+L)</source>
   <extracomment>[procc_annotator/gui/window/commands.py]</extracomment>
   <translation>比較するには 2 つ目のカメラセットを読み込んでください（Ctrl+L）</translation>
  </message>
  <message>
   <source>Brightness</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>明るさ</translation>
  </message>
  <message>
   <source>Contrast</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>コントラスト</translation>
  </message>
  <message>
   <source>Gamma</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>ガンマ</translation>
  </message>
  <message>
   <source>Bring out worn and shaded lines</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>擦れた線や影の中の線を際立たせます</translation>
  </message>
  <message>
   <source>Only what you see changes, never the file</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>変わるのは見え方だけで、ファイルは変わりません</translation>
  </message>
  <message>
   <source>Reset</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>リセット</translation>
  </message>
  <message>
   <source>Shift all values</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>すべての値をずらします</translation>
  </message>
  <message>
   <source>Stretch values about middle grey</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>中間の灰色を中心に値を広げます</translation>
  </message>
  <message>
   <source>To the right, dark parts become lighter</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>右へ動かすと暗い部分が明るくなります</translation>
  </message>
  <message>
   <source>Line enhance</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>線の強調</translation>
  </message>
  <message>
   <source>Show the picture as it is</source>
   <extracomment>[procc_annotator/gui/window/display_adjustment.py]</extracomment>
   <translation>画像をそのまま表示します</translation>
  </message>
  <message>
   <source>Keys of your own</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>自分のキー</translation>
  </message>
  <message>
   <source>Keys (*.json)</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>キー (*.json)</translation>
  </message>
  <message>
   <source>{menu}: {action}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{menu}：{action}</translation>
  </message>
  <message>
   <source>Search: a word, or a key. A click does what a row says.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>検索：単語またはキー。行をクリックすると実行します。</translation>
  </message>
  <message>
   <source>In the picture</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>画像で</translation>
  </message>
  <message>
   <source>No key, action or element has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>「{text}」を含むキー、操作、要素はありません。</translation>
  </message>
  <message>
   <source>Search: a word, or a key</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>検索：単語またはキー</translation>
  </message>
  <message>
   <source>Choose a row, then press its keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>行を選び、割り当てるキーを押してください</translation>
  </message>
  <message>
   <source>{one} or {other}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{one} または {other}</translation>
  </message>
  <message>
   <source>Keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py, the action keys]</extracomment>
   <translation>キー一覧</translation>
  </message>
  <message>
   <source>Change keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>キーを変更</translation>
  </message>
  <message>
   <source>Only these</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>これだけ</translation>
  </message>
  <message>
   <source>No keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>キーなし</translation>
  </message>
  <message>
   <source>Default keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>既定のキー</translation>
  </message>
  <message>
   <source>Import…</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>取り込む…</translation>
  </message>
  <message>
   <source>⚠ Keys that call two actions call neither: give one of them other keys.</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ 2 つの操作に割り当てたキーはどちらも呼びません。一方に別のキーを割り当ててください。</translation>
  </message>
  <message>
   <source>Export keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>キーを書き出す</translation>
  </message>
  <message>
   <source>Import keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>キーを取り込む</translation>
  </message>
  <message>
   <source>New keys: press them here</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>新しいキー：ここで押す</translation>
  </message>
  <message>
   <source>Search the keys</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>キーを検索</translation>
  </message>
  <message>
   <source>Search</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>検索</translation>
  </message>
  <message>
   <source>All keys at once</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>すべてのキーをまとめて</translation>
  </message>
  <message>
   <source>{file}: {error}; the keys stay as they are</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>{file}：{error}。キーは変わりません</translation>
  </message>
  <message>
   <source>Action or element</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>操作または要素</translation>
  </message>
  <message>
   <source>⚠ also: {what}</source>
   <extracomment>[procc_annotator/gui/window/key_dialogs.py]</extracomment>
   <translation>⚠ 重複：{what}</translation>
  </message>
  <message>
   <source>Change class to (swaps with an annotated one)</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>クラスを変更（注釈済みなら入れ替え）</translation>
  </message>
  <message>
   <source>Drawing {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title} を描画中</translation>
  </message>
  <message>
   <source>Split here: the rest becomes</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>ここで分割：残りのクラス</translation>
  </message>
  <message>
   <source>Ghost of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title} のゴースト</translation>
  </message>
  <message>
   <source>Accept</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>採用</translation>
  </message>
  <message>
   <source>Look closely</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>拡大して見る</translation>
  </message>
  <message>
   <source>Not visible here</source>
   <extracomment>[procc_annotator/gui/window/menus.py, the action not_visible]</extracomment>
   <translation>ここでは見えない</translation>
  </message>
  <message>
   <source>{action}: {step}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{action}：{step}</translation>
  </message>
  <message>
   <source>Point {number} of {title}</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title} の点 {number}</translation>
  </message>
  <message>
   <source>Not visible here: take back</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>ここでは見えない：取り消す</translation>
  </message>
  <message>
   <source>Merge into</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>統合先</translation>
  </message>
  <message>
   <source>{title}, unconfirmed</source>
   <extracomment>[procc_annotator/gui/window/menus.py]</extracomment>
   <translation>{title}（未確定）</translation>
  </message>
  <message>
   <source>ground ±{metres:.2f} m</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>地面 ±{metres:.2f} m</translation>
  </message>
  <message>
   <source>unexpected error ({what}); saving goes on, the details are in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>予期しないエラー ({what})。保存は続きます。詳細は {path} にあります</translation>
  </message>
  <message>
   <source>Cursor in picture pixels; the centre of the top left pixel is 0 0</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>カーソルの画像ピクセル座標。左上のピクセルの中心が 0 0</translation>
  </message>
  <message>
   <source>Cursor on the ground of the field, in metres from its centre</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>カーソルの地面上の位置。フィールド中心からのメートル</translation>
  </message>
  <message>
   <source>How far apart the active and the compared camera see the cursor:
on the ground, and in pixels of the evaluation size</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>使用中と比較中のカメラがカーソルをどれだけずれて見るか：
地面上と、評価サイズのピクセル</translation>
  </message>
  <message>
   <source>How surely the fitted camera knows the ground point at the cursor: standard
deviation in the worst direction, whatever the cursor itself is off by</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>当てはめたカメラがカーソルの地面点をどれだけ確かに知るか：
最悪方向の標準偏差（カーソル自体のずれは含まない）</translation>
  </message>
  <message>
   <source>scoring {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>採点 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Camera &gt; Stop scoring the set ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>カメラ &gt; セットの採点を止める で終わります</translation>
  </message>
  <message>
   <source>comparing {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>比較 {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>ghosts {done:,} / {total:,}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>ゴースト {done:,} / {total:,}</translation>
  </message>
  <message>
   <source>Esc ends it</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>Esc で終わります</translation>
  </message>
  <message>
   <source>This frame is not editable. {problem}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>このフレームは編集できません。{problem}</translation>
  </message>
  <message>
   <source>the details are copied; they are in {path}, too</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>詳細をコピーしました。{path} にもあります</translation>
  </message>
  <message>
   <source>there was no unexpected error; they are logged in {path}</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>予期しないエラーはありませんでした。記録先は {path} です</translation>
  </message>
  <message>
   <source>not editable: the bar over the picture says why</source>
   <extracomment>[procc_annotator/gui/window/status.py]</extracomment>
   <translation>編集できません。理由は画像の上のバーにあります</translation>
  </message>
  <message>
   <source>Picture
Brightness, contrast, gamma, line enhance: only what you see changes</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>画像
明るさ、コントラスト、ガンマ、線の強調：見え方だけが変わります</translation>
  </message>
  <message>
   <source>Rail</source>
   <extracomment>[procc_annotator/gui/window/tool_bar.py]</extracomment>
   <translation>ツールバー</translation>
  </message>
  <message>
   <source>Jaccard index of this frame at tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>tau でのこのフレームの Jaccard 指数</translation>
  </message>
  <message>
   <source>Threshold tau: an element passes when all its points are nearer (+ and -)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>しきい値 tau：すべての点がこれより近ければ要素は合格（+ と -）</translation>
  </message>
  <message>
   <source>The camera set that is judged (C switches)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>評価されるカメラのセット（C で切り替え）</translation>
  </message>
  <message>
   <source>Status of this frame (panel Review)</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>このフレームの状態（レビューパネル）</translation>
  </message>
  <message>
   <source>What the score is computed with: {terms}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>スコアの計算条件：{terms}</translation>
  </message>
  <message>
   <source>saved {time}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>保存 {time}</translation>
  </message>
  <message numerus="yes">
   <source>NOT SAVED: {n} frames</source>
   <extracomment>NOT SAVED: {n} frame / NOT SAVED: {n} frames [procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>
    <numerusform>未保存：{n} フレーム</numerusform>
   </translation>
  </message>
  <message>
   <source>Field: {field}</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>フィールド：{field}</translation>
  </message>
  <message>
   <source>Click to choose another one</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>クリックで別のものを選択</translation>
  </message>
  <message>
   <source>saving...</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>保存中...</translation>
  </message>
  <message>
   <source>Threshold tau</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>しきい値 tau</translation>
  </message>
  <message>
   <source>JaC {jac:.3f} of the fit</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>JaC {jac:.3f} (fit)</translation>
  </message>
  <message>
   <source>blind: commit to see JaC</source>
   <extracomment>[procc_annotator/gui/window/top_bar.py]</extracomment>
   <translation>ブラインド：未提出</translation>
  </message>
  <message>
   <source>{n} of {total}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>{n} / {total}</translation>
  </message>
  <message>
   <source>The camera is found without a click; dashed: what it expects. Shift+Enter accepts that</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>カメラはクリックなしで見つかります。破線はその予測です。Shift+Enter で受け入れます</translation>
  </message>
  <message>
   <source>W switches to editing: drag a point off its line</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>W で編集に切り替わります：点を線からずらしてください</translation>
  </message>
  <message>
   <source>The tab Check lists possible mistakes: open it. F12 applies the first remedy</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>「検査」タブに誤りの候補が出ます：開いてください。F12 で最初の対処を行います</translation>
  </message>
  <message>
   <source>Ctrl+Enter: this frame is done</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Enter：このフレームは完了です</translation>
  </message>
  <message>
   <source>Ctrl+Shift+D: a frame without annotation. W, and draw a line: click its ends, press Enter, choose its name</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Ctrl+Shift+D：注釈のないフレームへ。W で描画：線の両端をクリックし、Enter、名前を選びます</translation>
  </message>
  <message>
   <source>Judge, at the top right (Shift+F2), then C: the fitted camera, judged by your annotation</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>右上の「評価」（Shift+F2）、次に C：当てはめたカメラを注釈と照らして評価します</translation>
  </message>
  <message>
   <source>File &gt; Export as… writes the annotations for other programs: look at it</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>ファイル &gt; 形式を選んで書き出す… は注釈をほかのプログラム用に書き出します：開いてください</translation>
  </message>
  <message>
   <source>That was the tour. Shift+F1: back to annotating; F1: all keys</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>ツアーは以上です。Shift+F1：注釈に戻る。F1：キー一覧</translation>
  </message>
  <message>
   <source>Go on to the next step</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>次のステップへ進みます</translation>
  </message>
  <message>
   <source>Esc ends the tour, too</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>Esc でもツアーを終えられます</translation>
  </message>
  <message>
   <source>Skip</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>スキップ</translation>
  </message>
  <message>
   <source>End</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>終了</translation>
  </message>
  <message>
   <source>the sample cannot be copied: {why}</source>
   <extracomment>[procc_annotator/gui/window/tour.py]</extracomment>
   <translation>サンプルをコピーできません：{why}</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>画像のフォルダーをここにドロップ</translation>
  </message>
  <message>
   <source>Annotations are read from and saved as JSON next to the pictures. Drop a folder of cameras later, to see them judged against your clicks.</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>注釈は画像の横の JSON から読み込み、そこに保存します。後でカメラのフォルダーをドロップすると、クリックと照らして評価します。</translation>
  </message>
  <message>
   <source>Open recent</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>最近使った項目</translation>
  </message>
  <message>
   <source>Open folder…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_folder]</extracomment>
   <translation>フォルダーを開く…</translation>
  </message>
  <message>
   <source>Open picture…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_picture]</extracomment>
   <translation>画像を開く…</translation>
  </message>
  <message>
   <source>Open video…</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action open_video]</extracomment>
   <translation>動画を開く…</translation>
  </message>
  <message>
   <source>Try the sample</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>サンプルを試す</translation>
  </message>
  <message>
   <source>Tour (60 seconds)</source>
   <extracomment>[procc_annotator/gui/window/welcome.py, the action tour]</extracomment>
   <translation>ツアー（60 秒）</translation>
  </message>
  <message>
   <source>Go on with</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>続きから</translation>
  </message>
  <message>
   <source>Nothing was opened yet</source>
   <extracomment>[procc_annotator/gui/window/welcome.py]</extracomment>
   <translation>まだ何も開いていません</translation>
  </message>
  <message>
   <source>{setting}: back to {value}</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>{setting}：{value} に戻す</translation>
  </message>
  <message>
   <source>No setting has “{text}”.</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>「{text}」を含む設定はありません。</translation>
  </message>
  <message>
   <source>Settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>設定</translation>
  </message>
  <message>
   <source>Search the settings</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>設定を検索</translation>
  </message>
  <message>
   <source>Reset all</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>すべてリセット</translation>
  </message>
  <message>
   <source>none of your own</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py]</extracomment>
   <translation>指定なし</translation>
  </message>
  <message>
   <source>Change keys…</source>
   <extracomment>[procc_annotator/gui/window/window_settings.py, the action keymap]</extracomment>
   <translation>キーを変更…</translation>
  </message>
  <message>
   <source>Scores</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>スコア</translation>
  </message>
  <message>
   <source>Fit</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>当てはめ</translation>
  </message>
  <message>
   <source>Check</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>検査</translation>
  </message>
  <message>
   <source>Plots</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py, the action plots]</extracomment>
   <translation>グラフ</translation>
  </message>
  <message>
   <source>Review</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>レビュー</translation>
  </message>
  <message>
   <source>Agreement</source>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>一致度</translation>
  </message>
  <message>
   <source>Annotate</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>注釈</translation>
  </message>
  <message>
   <source>Judge</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>評価</translation>
  </message>
  <message>
   <source>Review</source>
   <comment>desk</comment>
   <extracomment>[procc_annotator/gui/window/workspaces.py]</extracomment>
   <translation>レビュー</translation>
  </message>
  <message>
   <source>Disagreement</source>
   <extracomment>[procc_annotator/interaction/camera_view.py, the action disagreement]</extracomment>
   <translation>不一致</translation>
  </message>
  <message>
   <source>Uncertainty</source>
   <extracomment>[procc_annotator/interaction/camera_view.py]</extracomment>
   <translation>不確かさ</translation>
  </message>
  <message numerus="yes">
   <source>{n} to go</source>
   <extracomment>{n} to go / {n} to go [procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>
    <numerusform>あと {n} 点</numerusform>
   </translation>
  </message>
  <message>
   <source>choose an element first: field map, list, or its key</source>
   <extracomment>[procc_annotator/interaction/draw_tool.py]</extracomment>
   <translation>まず要素を選んでください：フィールド図、一覧、またはそのキー</translation>
  </message>
  <message>
   <source>{title} is pinned, so that a slip does not move it: drag its points, or unpin elements (Ctrl+P, menu Element) to drag it as a whole</source>
   <extracomment>[procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>{title} は誤って動かないよう固定されています。点をドラッグするか、全体を動かすには要素の固定を外してください（Ctrl+P、要素メニュー）</translation>
  </message>
  <message numerus="yes">
   <source>move {n} points</source>
   <extracomment>move {n} point / move {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>{n} 点を動かす</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>delete {n} points</source>
   <extracomment>delete {n} point / delete {n} points [procc_annotator/interaction/edit_tool.py]</extracomment>
   <translation>
    <numerusform>{n} 点を削除</numerusform>
   </translation>
  </message>
  <message>
   <source>draw {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} を描く</translation>
  </message>
  <message>
   <source>continue {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} の続きを描く</translation>
  </message>
  <message>
   <source>confirm {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} を確定</translation>
  </message>
  <message>
   <source>move {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} を動かす</translation>
  </message>
  <message>
   <source>move all of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} 全体を動かす</translation>
  </message>
  <message>
   <source>nudge {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} を微調整</translation>
  </message>
  <message>
   <source>insert a point in {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} に点を挿入</translation>
  </message>
  <message>
   <source>delete {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} を削除</translation>
  </message>
  <message>
   <source>delete point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/gestures.py]</extracomment>
   <translation>{title} の点 {number} を削除</translation>
  </message>
  <message numerus="yes">
   <source>nudge {n} points</source>
   <extracomment>nudge {n} point / nudge {n} points [procc_annotator/interaction/gestures.py]</extracomment>
   <translation>
    <numerusform>{n} 点を微調整</numerusform>
   </translation>
  </message>
  <message>
   <source>click to draw; choose its class afterwards</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで描く。クラスは後で選択</translation>
  </message>
  <message>
   <source>Backspace removes the last point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Backspace で最後の点を取り除く</translation>
  </message>
  <message>
   <source>click marks it and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで印を付け、{title} へ進む</translation>
  </message>
  <message>
   <source>release drops it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>離すとここに置く</translation>
  </message>
  <message>
   <source>click or drag a point, drag elsewhere to select several</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点をクリックまたはドラッグ、ほかの所をドラッグで複数選択</translation>
  </message>
  <message>
   <source>arrows nudge {step:g} px, with Shift {fine:g} px, Ctrl {far:g} px</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>矢印キーで {step:g} px、Shift で {fine:g} px、Ctrl で {far:g} px 動かす</translation>
  </message>
  <message>
   <source>Drop a folder of pictures here, or open one with Ctrl+O</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>画像のフォルダーをここにドロップするか、Ctrl+O で開く</translation>
  </message>
  <message>
   <source>Ctrl+Enter commits the frame and shows the projection</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Ctrl+Enter でフレームを提出し、投影を表示</translation>
  </message>
  <message>
   <source>GHOST {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ゴースト {title}</translation>
  </message>
  <message>
   <source>GHOST the next one comes in a moment</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ゴースト 次がまもなく来ます</translation>
  </message>
  <message numerus="yes">
   <source>Tab: next of {n} ghosts</source>
   <extracomment>Tab: next of {n} ghost / Tab: next of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab：{n} 個中の次のゴースト</numerusform>
   </translation>
  </message>
  <message numerus="yes">
   <source>Tab: first of {n} ghosts</source>
   <extracomment>Tab: first of {n} ghost / Tab: first of {n} ghosts [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Tab：{n} 個中の最初のゴースト</numerusform>
   </translation>
  </message>
  <message>
   <source>Shift+Enter: accept all</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Shift+Enter：すべて採用</translation>
  </message>
  <message>
   <source>Enter accepts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Enter で採用</translation>
  </message>
  <message>
   <source>Tab goes on</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Tab で次へ</translation>
  </message>
  <message>
   <source>. not visible here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>. ここでは見えない</translation>
  </message>
  <message>
   <source>Esc goes back</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc で戻る</translation>
  </message>
  <message>
   <source>/ finds an element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>/ で要素を探す</translation>
  </message>
  <message>
   <source>DRAW</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>描画</translation>
  </message>
  <message>
   <source>choose an element: field map, list, its key or /</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>要素を選ぶ：フィールド図、一覧、そのキー、または /</translation>
  </message>
  <message numerus="yes">
   <source>DRAW a line, {n} points</source>
   <extracomment>DRAW a line, {n} point / DRAW a line, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>描画 線、{n} 点</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes, then choose the class</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Enter またはダブルクリックで終え、クラスを選ぶ</translation>
  </message>
  <message numerus="yes">
   <source>DRAW {title}, {n} points</source>
   <extracomment>DRAW {title}, {n} point / DRAW {title}, {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>描画 {title}、{n} 点</numerusform>
   </translation>
  </message>
  <message>
   <source>Enter or double-click finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Enter またはダブルクリックで終える</translation>
  </message>
  <message>
   <source>click adds the second point and finishes</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで 2 点目を加えて終える</translation>
  </message>
  <message>
   <source>click adds a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで点を加える</translation>
  </message>
  <message>
   <source>DRAW {title}, unconfirmed</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>描画 {title}、未確定</translation>
  </message>
  <message>
   <source>DRAW {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>描画 {title}</translation>
  </message>
  <message>
   <source>Enter confirms it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Enter で確定</translation>
  </message>
  <message>
   <source>choose it again, then clicks continue it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>もう一度選ぶと、クリックで続けられます</translation>
  </message>
  <message numerus="yes">
   <source>click continues it after its {n} points</source>
   <extracomment>click continues it after its {n} point / click continues it after its {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>クリックで {n} 点の続きを描く</numerusform>
   </translation>
  </message>
  <message>
   <source>click starts it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで描き始める</translation>
  </message>
  <message>
   <source>click moves it here and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックでここへ動かし、{title} へ進む</translation>
  </message>
  <message>
   <source>Enter confirms {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Enter で {title} を確定</translation>
  </message>
  <message numerus="yes">
   <source>Esc deselects {n} points</source>
   <extracomment>Esc deselects the point / Esc deselects {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Esc で {n} 点の選択を解除</numerusform>
   </translation>
  </message>
  <message>
   <source>EDIT</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>編集</translation>
  </message>
  <message>
   <source>release selects all points inside</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>離すと中の点をすべて選択</translation>
  </message>
  <message>
   <source>EDIT point {number} of {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>編集 {title} の点 {number}</translation>
  </message>
  <message>
   <source>release selects the element, which is pinned</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>離すと固定された要素を選択</translation>
  </message>
  <message>
   <source>EDIT the element</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>編集 要素全体</translation>
  </message>
  <message>
   <source>drag moves point {number} of {title}, Alt+Shift+click removes it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ドラッグで {title} の点 {number} を動かす、Alt+Shift+クリックで取り除く</translation>
  </message>
  <message>
   <source>click selects {title}, Alt+click inserts a point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで {title} を選択、Alt+クリックで点を挿入</translation>
  </message>
  <message>
   <source>click does nothing: there are no points to edit, draw an element first</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックは働きません：編集する点がありません。まず要素を描いてください</translation>
  </message>
  <message>
   <source>click a point to drag it, elsewhere to deselect</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>点をクリックしてドラッグ、ほかの所をクリックで解除</translation>
  </message>
  <message numerus="yes">
   <source>Delete removes {n} points</source>
   <extracomment>Delete removes the point / Delete removes {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Delete で {n} 点を取り除く</numerusform>
   </translation>
  </message>
  <message>
   <source>click draws it by hand</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで手描き</translation>
  </message>
  <message numerus="yes">
   <source>Enter accepts {n} points</source>
   <extracomment>Enter accepts {n} point / Enter accepts {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>Enter で {n} 点を採用</numerusform>
   </translation>
  </message>
  <message>
   <source>no line found along it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>沿った線が見つかりません</translation>
  </message>
  <message>
   <source>an element's key names it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>要素のキーで名付ける</translation>
  </message>
  <message>
   <source>Enter or double-click finishes and goes on to {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Enter またはダブルクリックで終え、{title} へ進む</translation>
  </message>
  <message>
   <source>Esc cancels</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc で取り消す</translation>
  </message>
  <message>
   <source>Esc deselects</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc で選択解除</translation>
  </message>
  <message>
   <source>click moves it here</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックでここへ動かす</translation>
  </message>
  <message>
   <source>click marks it</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>クリックで印を付ける</translation>
  </message>
  <message>
   <source>hold Ctrl: no snapping</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Ctrl を押す間：吸着なし</translation>
  </message>
  <message>
   <source>Delete removes {title}</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Delete で {title} を取り除く</translation>
  </message>
  <message>
   <source>EDIT choosing points</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>編集 点を選択中</translation>
  </message>
  <message numerus="yes">
   <source>EDIT {n} points</source>
   <extracomment>EDIT {n} point / EDIT {n} points [procc_annotator/interaction/hints.py]</extracomment>
   <translation>
    <numerusform>編集 {n} 点</numerusform>
   </translation>
  </message>
  <message>
   <source>READ ONLY</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>読み取り専用</translation>
  </message>
  <message>
   <source>BLIND</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>ブラインド</translation>
  </message>
  <message>
   <source>Shift+Enter finishes and stays</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Shift+Enter で終えてとどまる</translation>
  </message>
  <message>
   <source>Esc removes the new point</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc で新しい点を取り除く</translation>
  </message>
  <message>
   <source>Esc lets go</source>
   <extracomment>[procc_annotator/interaction/hints.py]</extracomment>
   <translation>Esc で放す</translation>
  </message>
  <message>
   <source>passes</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>合格</translation>
  </message>
  <message>
   <source>too far</source>
   <extracomment>[procc_annotator/interaction/legend.py, procc_annotator/interaction/palette.py]</extracomment>
   <translation>遠すぎる</translation>
  </message>
  <message>
   <source>annotated, not projected</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>注釈あり、投影なし</translation>
  </message>
  <message>
   <source>projected, not annotated</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>投影あり、注釈なし</translation>
  </message>
  <message>
   <source>ghost of an unsure camera</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>不確かなカメラのゴースト</translation>
  </message>
  <message>
   <source>ghost: expected here</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>ゴースト：ここに予想</translation>
  </message>
  <message>
   <source>annotated, in its class's colour</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>注釈、クラスの色</translation>
  </message>
  <message>
   <source>to be confirmed</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>確定待ち</translation>
  </message>
  <message>
   <source>projection</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>投影</translation>
  </message>
  <message>
   <source>second annotator</source>
   <extracomment>[procc_annotator/interaction/legend.py]</extracomment>
   <translation>2 人目の注釈者</translation>
  </message>
  <message>
   <source>no distance</source>
   <extracomment>[procc_annotator/interaction/overlay_primitives.py]</extracomment>
   <translation>距離なし</translation>
  </message>
  <message>
   <source>not annotated</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>注釈なし</translation>
  </message>
  <message>
   <source>missed</source>
   <extracomment>[procc_annotator/interaction/palette.py]</extracomment>
   <translation>見逃し</translation>
  </message>
  <message>
   <source>{element} agrees: its farthest point, {number}, is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} は合っています：最も遠い点 {number} のずれは {px} px。tau &gt; {px} で合格。</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} is {px} px off; it passes at tau &gt; {px}.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} は遠すぎます：点 {number} のずれは {px} px。tau &gt; {px} で合格。</translation>
  </message>
  <message>
   <source>{title} (judged as {other}, labels mirrored)</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{title}（{other} として評価、鏡像のクラス）</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the camera does not show it in the picture.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} は見逃しです：注釈されていますが、カメラでは画像に写りません。</translation>
  </message>
  <message>
   <source>{element} is not annotated, but the camera shows it: a false positive.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} は注釈がありませんが、カメラでは写ります：偽陽性。</translation>
  </message>
  <message>
   <source>{element} is too far: point {number} has no distance, because the projection has coinciding samples there; it passes at no tau.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} は遠すぎます：投影の標本点がそこで重なるため、点 {number} には距離がありません。どの tau でも合格しません。</translation>
  </message>
  <message>
   <source>As it goes on beyond the picture it is at most {px} px off, but soccernet measures to what is in the picture alone.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>画像の外への延長までなら最大 {px} px のずれですが、soccernet は画像内の部分までしか測りません。</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but the field has no such element to project.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} は見逃しです：注釈されていますが、投影すべきそのような要素がフィールドにありません。</translation>
  </message>
  <message>
   <source>{element} is missed: it is annotated, but it leaves the ground, and the camera knows only the ground.</source>
   <extracomment>[procc_annotator/metrics/score.py]</extracomment>
   <translation>{element} は見逃しです：注釈されていますが、地面から離れた要素で、カメラは地面しか知りません。</translation>
  </message>
  <message>
   <source>Annotate all pictures of a folder</source>
   <extracomment>[the action open_folder]</extracomment>
   <translation>フォルダー内のすべての画像に注釈を付けます</translation>
  </message>
  <message>
   <source>Annotate a single picture</source>
   <extracomment>[the action open_picture]</extracomment>
   <translation>1 枚の画像に注釈を付けます</translation>
  </message>
  <message>
   <source>Annotate frames of a video without extracting them first</source>
   <extracomment>[the action open_video]</extracomment>
   <translation>動画のフレームを書き出さずに注釈を付けます</translation>
  </message>
  <message>
   <source>Season…</source>
   <extracomment>[the action season]</extracomment>
   <translation>シーズン…</translation>
  </message>
  <message>
   <source>List the matches of a season (a folder in which videos lie) to open one of them</source>
   <extracomment>[the action season]</extracomment>
   <translation>シーズン（動画のあるフォルダー）の試合を一覧表示し、その一つを開きます</translation>
  </message>
  <message>
   <source>Open the sample</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>サンプルを開く</translation>
  </message>
  <message>
   <source>Open your own copy of the frames that come with the program</source>
   <extracomment>[the action open_sample]</extracomment>
   <translation>プログラム付属のフレームを自分用にコピーして開きます</translation>
  </message>
  <message>
   <source>Open second annotator…</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>2 人目の注釈を開く…</translation>
  </message>
  <message>
   <source>Draw and compare what another annotator clicked in the same frames</source>
   <extracomment>[the action open_second]</extracomment>
   <translation>同じフレームで別の人がクリックした結果を描いて比較します</translation>
  </message>
  <message>
   <source>Close second annotator</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>2 人目の注釈を閉じる</translation>
  </message>
  <message>
   <source>Show only the annotations of this dataset again</source>
   <extracomment>[the action close_second]</extracomment>
   <translation>このデータセットの注釈だけの表示に戻します</translation>
  </message>
  <message>
   <source>From a file…</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>ファイルから…</translation>
  </message>
  <message>
   <source>A description of your own: any sport, see the user guide</source>
   <extracomment>[the action field_file]</extracomment>
   <translation>自分で書いた定義。どの競技でも可能です（ガイド参照）</translation>
  </message>
  <message>
   <source>Switch to the field that fits</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>合うフィールドに切り替える</translation>
  </message>
  <message>
   <source>Show the field that knows the classes annotated in this frame</source>
   <extracomment>[the action switch_field]</extracomment>
   <translation>このフレームで注釈されたクラスを持つフィールドを表示します</translation>
  </message>
  <message>
   <source>Read the file again</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>ファイルを読み直す</translation>
  </message>
  <message>
   <source>Done by itself when the file of this dataset's field is written</source>
   <extracomment>[the action field_again]</extracomment>
   <translation>このデータセットのフィールドのファイルが書かれると自動で行われます</translation>
  </message>
  <message>
   <source>Save now</source>
   <extracomment>[the action save]</extracomment>
   <translation>今すぐ保存</translation>
  </message>
  <message>
   <source>Every finished edit is saved at once; this tries again what failed</source>
   <extracomment>[the action save]</extracomment>
   <translation>終わった編集はすぐ保存されます。失敗した保存をやり直します</translation>
  </message>
  <message>
   <source>Write what could not be saved in its own place to another folder</source>
   <extracomment>[the action save_copies]</extracomment>
   <translation>本来の場所に保存できなかったものを別のフォルダーに書き出します</translation>
  </message>
  <message>
   <source>Import annotations…</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>注釈を取り込む…</translation>
  </message>
  <message>
   <source>Take annotations of another program or dataset into this one, frame by frame</source>
   <extracomment>[the action import_annotations]</extracomment>
   <translation>ほかのプログラムやデータセットの注釈をフレームごとに取り込みます</translation>
  </message>
  <message>
   <source>Export as…</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>形式を選んで書き出す…</translation>
  </message>
  <message>
   <source>Write the annotations for another program: CVAT, labelme, COCO, SoccerNet, masks</source>
   <extracomment>[the action export_as]</extracomment>
   <translation>ほかのプログラム用に注釈を書き出します：CVAT、labelme、COCO、SoccerNet、マスク</translation>
  </message>
  <message>
   <source>Export annotations as JSON…</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>注釈を JSON で書き出す…</translation>
  </message>
  <message>
   <source>Write the annotations of all frames as a folder or zip of JSON files</source>
   <extracomment>[the action export_annotations]</extracomment>
   <translation>全フレームの注釈を JSON ファイルのフォルダーまたは zip に書き出します</translation>
  </message>
  <message>
   <source>Export JaC of the set…</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>セットの JaC を書き出す…</translation>
  </message>
  <message>
   <source>Write the JaC of every frame as CSV or JSON</source>
   <extracomment>[the action export_scores]</extracomment>
   <translation>各フレームの JaC を CSV または JSON に書き出します</translation>
  </message>
  <message>
   <source>Export provenance…</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>来歴を書き出す…</translation>
  </message>
  <message>
   <source>Write how every point came to be, and through whom, as a sidecar JSON</source>
   <extracomment>[the action export_provenance]</extracomment>
   <translation>各点がどのように、誰によって作られたかを別の JSON に書き出します</translation>
  </message>
  <message>
   <source>Save overlay picture…</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>重ね描き画像を保存…</translation>
  </message>
  <message>
   <source>Write the picture with annotation and projection as PNG, JPEG or SVG, with a legend</source>
   <extracomment>[the action save_overlay]</extracomment>
   <translation>注釈と投影と凡例付きの画像を PNG、JPEG、SVG に書き出します</translation>
  </message>
  <message>
   <source>Export overview…</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>概要を書き出す…</translation>
  </message>
  <message>
   <source>Write status, counts and time of every frame as CSV</source>
   <extracomment>[the action export_overview]</extracomment>
   <translation>各フレームの状態、数、時間を CSV に書き出します</translation>
  </message>
  <message>
   <source>Export verdicts…</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>判定を書き出す…</translation>
  </message>
  <message>
   <source>Write who is at fault in which frame, with JaC and largest error, as CSV</source>
   <extracomment>[the action export_verdicts]</extracomment>
   <translation>どのフレームで何が誤りかを JaC と最大誤差とともに CSV に書き出します</translation>
  </message>
  <message>
   <source>Export findings…</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>指摘を書き出す…</translation>
  </message>
  <message>
   <source>Write what the label check found in the frames checked so far, as CSV</source>
   <extracomment>[the action export_findings]</extracomment>
   <translation>これまでに検査したフレームのクラス検査の指摘を CSV に書き出します</translation>
  </message>
  <message>
   <source>Author name…</source>
   <extracomment>[the action author]</extracomment>
   <translation>作成者名…</translation>
  </message>
  <message>
   <source>The name your points, comments and versions bear</source>
   <extracomment>[the action author]</extracomment>
   <translation>点、コメント、版に付く名前です</translation>
  </message>
  <message>
   <source>Quit</source>
   <extracomment>[the action quit]</extracomment>
   <translation>終了</translation>
  </message>
  <message>
   <source>Close the window; everything is saved</source>
   <extracomment>[the action quit]</extracomment>
   <translation>ウィンドウを閉じます。すべて保存済みです</translation>
  </message>
  <message>
   <source>Undo</source>
   <extracomment>[the action undo]</extracomment>
   <translation>元に戻す</translation>
  </message>
  <message>
   <source>Take back the last step of this frame</source>
   <extracomment>[the action undo]</extracomment>
   <translation>このフレームの最後の操作を取り消します</translation>
  </message>
  <message>
   <source>Redo</source>
   <extracomment>[the action redo]</extracomment>
   <translation>やり直す</translation>
  </message>
  <message>
   <source>Do the step again</source>
   <extracomment>[the action redo]</extracomment>
   <translation>取り消した操作をもう一度行います</translation>
  </message>
  <message>
   <source>Delete point or element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>点または要素を削除</translation>
  </message>
  <message>
   <source>Remove the selected point; without one, the selected element</source>
   <extracomment>[the action delete]</extracomment>
   <translation>選択中の点を取り除きます。なければ選択中の要素を取り除きます</translation>
  </message>
  <message>
   <source>Insert point</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>点を挿入</translation>
  </message>
  <message>
   <source>Put a point on the line at the crosshair, or at the mouse (Alt and a click do it, too)</source>
   <extracomment>[the action insert_point]</extracomment>
   <translation>十字カーソルまたはマウスの位置の線上に点を置きます（Alt+クリックでも可）</translation>
  </message>
  <message>
   <source>Choose all points</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>すべての点を選ぶ</translation>
  </message>
  <message>
   <source>Choose all points of the selected element, or of the frame</source>
   <extracomment>[the action select_all]</extracomment>
   <translation>選択中の要素、またはフレームのすべての点を選びます</translation>
  </message>
  <message>
   <source>Drop the points just clicked, then let go of the selection</source>
   <extracomment>[the action cancel]</extracomment>
   <translation>クリックしたばかりの点を捨て、次に選択を解除します</translation>
  </message>
  <message>
   <source>Settings…</source>
   <extracomment>[the action settings]</extracomment>
   <translation>設定…</translation>
  </message>
  <message>
   <source>Theme, text size, and how the window draws, fits and judges</source>
   <extracomment>[the action settings]</extracomment>
   <translation>テーマ、文字の大きさ、描画・当てはめ・評価の方法</translation>
  </message>
  <message>
   <source>By the arrows</source>
   <extracomment>[the menus]</extracomment>
   <translation>矢印キー</translation>
  </message>
  <message>
   <source>Left 1 px</source>
   <extracomment>[the action nudge_left]</extracomment>
   <translation>左へ 1 px</translation>
  </message>
  <message>
   <source>Move the chosen points 1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down, the action nudge_left, the action nudge_right]</extracomment>
   <translation>選んだ点を 1 px 動かします。なければ十字カーソルを動かします</translation>
  </message>
  <message>
   <source>Right 1 px</source>
   <extracomment>[the action nudge_right]</extracomment>
   <translation>右へ 1 px</translation>
  </message>
  <message>
   <source>Up 1 px</source>
   <extracomment>[the action nudge_up]</extracomment>
   <translation>上へ 1 px</translation>
  </message>
  <message>
   <source>Down 1 px</source>
   <extracomment>[the action nudge_down]</extracomment>
   <translation>下へ 1 px</translation>
  </message>
  <message>
   <source>Left 0.1 px</source>
   <extracomment>[the action nudge_left_fine]</extracomment>
   <translation>左へ 0.1 px</translation>
  </message>
  <message>
   <source>Move the chosen points 0.1 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_fine, the action nudge_left_fine, the action nudge_right_fine]</extracomment>
   <translation>選んだ点を 0.1 px 動かします。なければ十字カーソルを動かします</translation>
  </message>
  <message>
   <source>Right 0.1 px</source>
   <extracomment>[the action nudge_right_fine]</extracomment>
   <translation>右へ 0.1 px</translation>
  </message>
  <message>
   <source>Up 0.1 px</source>
   <extracomment>[the action nudge_up_fine]</extracomment>
   <translation>上へ 0.1 px</translation>
  </message>
  <message>
   <source>Down 0.1 px</source>
   <extracomment>[the action nudge_down_fine]</extracomment>
   <translation>下へ 0.1 px</translation>
  </message>
  <message>
   <source>Left 10 px</source>
   <extracomment>[the action nudge_left_far]</extracomment>
   <translation>左へ 10 px</translation>
  </message>
  <message>
   <source>Move the chosen points 10 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_far, the action nudge_left_far, the action nudge_right_far]</extracomment>
   <translation>選んだ点を 10 px 動かします。なければ十字カーソルを動かします</translation>
  </message>
  <message>
   <source>Right 10 px</source>
   <extracomment>[the action nudge_right_far]</extracomment>
   <translation>右へ 10 px</translation>
  </message>
  <message>
   <source>Up 10 px</source>
   <extracomment>[the action nudge_up_far]</extracomment>
   <translation>上へ 10 px</translation>
  </message>
  <message>
   <source>Down 10 px</source>
   <extracomment>[the action nudge_down_far]</extracomment>
   <translation>下へ 10 px</translation>
  </message>
  <message>
   <source>Left 100 px</source>
   <extracomment>[the action nudge_left_farther]</extracomment>
   <translation>左へ 100 px</translation>
  </message>
  <message>
   <source>Move the chosen points 100 px; where none is chosen, the crosshair</source>
   <extracomment>[the action nudge_down_farther, the action nudge_left_farther, the action nudge_right_farther]</extracomment>
   <translation>選んだ点を 100 px 動かします。なければ十字カーソルを動かします</translation>
  </message>
  <message>
   <source>Right 100 px</source>
   <extracomment>[the action nudge_right_farther]</extracomment>
   <translation>右へ 100 px</translation>
  </message>
  <message>
   <source>Up 100 px</source>
   <extracomment>[the action nudge_up_farther]</extracomment>
   <translation>上へ 100 px</translation>
  </message>
  <message>
   <source>Down 100 px</source>
   <extracomment>[the action nudge_down_farther]</extracomment>
   <translation>下へ 100 px</translation>
  </message>
  <message>
   <source>Next frame</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>次のフレーム</translation>
  </message>
  <message>
   <source>Show the next picture, of those that the filter shows</source>
   <extracomment>[the action next_frame]</extracomment>
   <translation>フィルターに合うものから次の画像を表示します</translation>
  </message>
  <message>
   <source>Previous frame</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>前のフレーム</translation>
  </message>
  <message>
   <source>Show the previous picture, of those that the filter shows</source>
   <extracomment>[the action previous_frame]</extracomment>
   <translation>フィルターに合うものから前の画像を表示します</translation>
  </message>
  <message>
   <source>Next unfinished</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>次の未完了</translation>
  </message>
  <message>
   <source>Go on to the next frame that is neither done nor approved</source>
   <extracomment>[the action next_unfinished]</extracomment>
   <translation>完了も承認もされていない次のフレームへ進みます</translation>
  </message>
  <message>
   <source>Previous unfinished</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>前の未完了</translation>
  </message>
  <message>
   <source>Go back to the frame before that is neither done nor approved</source>
   <extracomment>[the action previous_unfinished]</extracomment>
   <translation>完了も承認もされていない前のフレームへ戻ります</translation>
  </message>
  <message>
   <source>Go to</source>
   <extracomment>[the menus]</extracomment>
   <translation>移動</translation>
  </message>
  <message>
   <source>Next rejected</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>次の差し戻し</translation>
  </message>
  <message>
   <source>Go on to the next frame that a reviewer sent back</source>
   <extracomment>[the action next_rejected]</extracomment>
   <translation>レビュー担当が差し戻した次のフレームへ進みます</translation>
  </message>
  <message>
   <source>Next worst JaC</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>JaC が次に低いフレーム</translation>
  </message>
  <message>
   <source>The frame with the lowest JaC; once more: the next better one</source>
   <extracomment>[the action next_worst]</extracomment>
   <translation>JaC が最も低いフレーム。もう一度で次に低いフレーム</translation>
  </message>
  <message>
   <source>Next largest error</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>誤差が次に大きいフレーム</translation>
  </message>
  <message>
   <source>The frame with the largest error of a point; once more: the next smaller one</source>
   <extracomment>[the action next_largest_error]</extracomment>
   <translation>点の誤差が最も大きいフレーム。もう一度で次に大きいフレーム</translation>
  </message>
  <message>
   <source>Next by disagreement</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>不一致の順で次</translation>
  </message>
  <message>
   <source>The frame where the active source and the compared one are farthest apart on the ground; once more: the next</source>
   <extracomment>[the action next_disagreement]</extracomment>
   <translation>使用中のソースと比較ソースが地面上で最も離れるフレーム。もう一度で次</translation>
  </message>
  <message>
   <source>Label check</source>
   <extracomment>[the menus]</extracomment>
   <translation>クラス検査</translation>
  </message>
  <message>
   <source>Next finding</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>次の指摘</translation>
  </message>
  <message>
   <source>Go to the next thing the label check found, from frame to frame</source>
   <extracomment>[the action next_finding]</extracomment>
   <translation>クラス検査の次の指摘へ、フレームをまたいで進みます</translation>
  </message>
  <message>
   <source>Previous finding</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>前の指摘</translation>
  </message>
  <message>
   <source>Go back to the finding before</source>
   <extracomment>[the action previous_finding]</extracomment>
   <translation>前の指摘へ戻ります</translation>
  </message>
  <message>
   <source>Do the first remedy</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>最初の対処を行う</translation>
  </message>
  <message>
   <source>Mend the current finding: relabel, swap, remove the bad point, or look at it</source>
   <extracomment>[the action apply_remedy]</extracomment>
   <translation>現在の指摘を直します：クラス変更、入れ替え、誤った点の削除、または確認</translation>
  </message>
  <message>
   <source>Next without annotation</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>次の注釈なし</translation>
  </message>
  <message>
   <source>Go to the next frame without annotations</source>
   <extracomment>[the action next_unannotated]</extracomment>
   <translation>何も注釈されていない次のフレームへ進みます</translation>
  </message>
  <message>
   <source>Previous without annotation</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>前の注釈なし</translation>
  </message>
  <message>
   <source>Go to the previous frame without annotations</source>
   <extracomment>[the action previous_unannotated]</extracomment>
   <translation>何も注釈されていない前のフレームへ戻ります</translation>
  </message>
  <message>
   <source>First frame</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>最初のフレーム</translation>
  </message>
  <message>
   <source>Show the first picture</source>
   <extracomment>[the action first_frame]</extracomment>
   <translation>最初の画像を表示します</translation>
  </message>
  <message>
   <source>Last frame</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>最後のフレーム</translation>
  </message>
  <message>
   <source>Show the last picture</source>
   <extracomment>[the action last_frame]</extracomment>
   <translation>最後の画像を表示します</translation>
  </message>
  <message>
   <source>Shot</source>
   <extracomment>[the menus]</extracomment>
   <translation>ショット</translation>
  </message>
  <message>
   <source>Follow the shot</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>ショットを追跡</translation>
  </message>
  <message>
   <source>Find the cameras of all frames of this shot, from this one in both directions; once more stops</source>
   <extracomment>[the action follow_shot]</extracomment>
   <translation>このフレームから前後に、ショット全フレームのカメラを求めます。もう一度で停止</translation>
  </message>
  <message>
   <source>Accept the stretch</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>区間を採用</translation>
  </message>
  <message>
   <source>Annotate the frames of the shot, or of the stretch marked on the strip, along their track; annotated ones are left out, and doubtful ones unless it is pressed again</source>
   <extracomment>[the action accept_stretch]</extracomment>
   <translation>ショット、またはストリップで選んだ区間のフレームを追跡に沿って注釈します。注釈済みは除かれ、疑わしいフレームはもう一度押した場合だけ含まれます</translation>
  </message>
  <message>
   <source>Annotate all that is sure</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>確かなものをすべて注釈</translation>
  </message>
  <message>
   <source>Annotate every frame of the dataset whose camera is found and sure, in one step; Next doubtful frame (Alt+PgDown) then goes through the others, the least sure first</source>
   <extracomment>[the action annotate_sure]</extracomment>
   <translation>カメラが見つかり確かなデータセットの全フレームを一度に注釈します。残りは「次の疑わしいフレーム」（Alt+PgDown）で不確かな順に見ます</translation>
  </message>
  <message>
   <source>Take back what was accepted last</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>最後の採用を取り消す</translation>
  </message>
  <message>
   <source>Frames that were accepted last and not edited since are as they were before</source>
   <extracomment>[the action take_back_stretch]</extracomment>
   <translation>最後に採用し、その後編集していないフレームを元の状態に戻します</translation>
  </message>
  <message>
   <source>Ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>10 フレーム先</translation>
  </message>
  <message>
   <source>Go ten frames on</source>
   <extracomment>[the action ten_on]</extracomment>
   <translation>10 フレーム進みます</translation>
  </message>
  <message>
   <source>Ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>10 フレーム前</translation>
  </message>
  <message>
   <source>Go ten frames back</source>
   <extracomment>[the action ten_back]</extracomment>
   <translation>10 フレーム戻ります</translation>
  </message>
  <message>
   <source>Next annotated frame</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>次の注釈済みフレーム</translation>
  </message>
  <message>
   <source>Go on to the next frame that is annotated</source>
   <extracomment>[the action next_anchor]</extracomment>
   <translation>次の注釈済みフレームへ進みます</translation>
  </message>
  <message>
   <source>Previous annotated frame</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>前の注釈済みフレーム</translation>
  </message>
  <message>
   <source>Go back to the annotated frame before</source>
   <extracomment>[the action previous_anchor]</extracomment>
   <translation>前の注釈済みフレームへ戻ります</translation>
  </message>
  <message>
   <source>Next doubtful frame</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>次の疑わしいフレーム</translation>
  </message>
  <message>
   <source>Go to the next frame whose track should be checked</source>
   <extracomment>[the action next_doubtful]</extracomment>
   <translation>追跡を確認すべき次のフレームへ進みます</translation>
  </message>
  <message>
   <source>Previous doubtful frame</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>前の疑わしいフレーム</translation>
  </message>
  <message>
   <source>Go back to the doubtful frame before</source>
   <extracomment>[the action previous_doubtful]</extracomment>
   <translation>前の疑わしいフレームへ戻ります</translation>
  </message>
  <message>
   <source>Play or pause</source>
   <extracomment>[the action play]</extracomment>
   <translation>再生・一時停止</translation>
  </message>
  <message>
   <source>Show the frames one after the other; once more, or any edit, stops</source>
   <extracomment>[the action play]</extracomment>
   <translation>フレームを順に表示します。もう一度、または編集すると停止します</translation>
  </message>
  <message>
   <source>Find frame…</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>フレームを探す…</translation>
  </message>
  <message>
   <source>Type a part of the frame's name</source>
   <extracomment>[the action find_frame]</extracomment>
   <translation>フレーム名の一部を入力します</translation>
  </message>
  <message>
   <source>Blind mode</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>ブラインドモード</translation>
  </message>
  <message>
   <source>Hide the projection until the frame is committed, so that the camera cannot pull the clicks</source>
   <extracomment>[the action blind, the setting blind]</extracomment>
   <translation>カメラにクリックが引きずられないよう、フレームを提出するまで投影を隠します</translation>
  </message>
  <message>
   <source>Lock the dataset to blind mode</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>データセットをブラインドモードに固定</translation>
  </message>
  <message>
   <source>Blind mode for everybody who annotates this dataset; unlocking asks, and is recorded</source>
   <extracomment>[the action lock_blind]</extracomment>
   <translation>このデータセットに注釈する全員をブラインドモードにします。解除は確認のうえ記録されます</translation>
  </message>
  <message>
   <source>Done</source>
   <extracomment>[the action commit]</extracomment>
   <translation>完了</translation>
  </message>
  <message>
   <source>This frame is done; in blind mode that shows the projection</source>
   <extracomment>[the action commit]</extracomment>
   <translation>このフレームは完了です。ブラインドモードでは投影が表示されます</translation>
  </message>
  <message>
   <source>A reviewer finds this frame right</source>
   <extracomment>[the action approve]</extracomment>
   <translation>レビュー担当がこのフレームを正しいと認めます</translation>
  </message>
  <message>
   <source>A reviewer sends this frame back; say why in a comment</source>
   <extracomment>[the action reject]</extracomment>
   <translation>レビュー担当がこのフレームを差し戻します。理由はコメントに書きます</translation>
  </message>
  <message>
   <source>In progress again</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>作業中に戻す</translation>
  </message>
  <message>
   <source>This frame is not done after all</source>
   <extracomment>[the action reopen]</extracomment>
   <translation>このフレームはまだ完了していません</translation>
  </message>
  <message>
   <source>Comment…</source>
   <extracomment>[the action comment]</extracomment>
   <translation>コメント…</translation>
  </message>
  <message>
   <source>Write to the thread of this frame</source>
   <extracomment>[the action comment]</extracomment>
   <translation>このフレームのスレッドに書き込みます</translation>
  </message>
  <message>
   <source>Comment on this place…</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>この場所にコメント…</translation>
  </message>
  <message>
   <source>Write a comment on the place at the cursor; a numbered pin marks it in the picture</source>
   <extracomment>[the action comment_here]</extracomment>
   <translation>カーソルの場所にコメントを書きます。番号付きのピンが画像に表示されます</translation>
  </message>
  <message>
   <source>Earlier versions…</source>
   <extracomment>[the action versions]</extracomment>
   <translation>以前の版…</translation>
  </message>
  <message>
   <source>Look at every saved version of this frame and bring one back</source>
   <extracomment>[the action versions]</extracomment>
   <translation>このフレームの保存済みの版をすべて見て、どれかを戻します</translation>
  </message>
  <message>
   <source>Group views…</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>ビューをまとめる…</translation>
  </message>
  <message>
   <source>Say by their names which frames show one instant from different cameras</source>
   <extracomment>[the action group_views]</extracomment>
   <translation>同じ瞬間を別のカメラから写したフレームを名前で指定します</translation>
  </message>
  <message>
   <source>Keep this video frame</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>この動画フレームを残す</translation>
  </message>
  <message>
   <source>Write the frame of the video as a picture next to its annotation</source>
   <extracomment>[the action keep_frame]</extracomment>
   <translation>動画のフレームを注釈と並べて画像として書き出します</translation>
  </message>
  <message>
   <source>Copy from the previous frame</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>前のフレームからコピー</translation>
  </message>
  <message>
   <source>Take over elements of the frame annotated before, moved as the camera moved; they wait to be confirmed</source>
   <extracomment>[the action copy_previous]</extracomment>
   <translation>前に注釈したフレームの要素をカメラの動きに合わせて移します。確認待ちになります</translation>
  </message>
  <message>
   <source>Confirm all unconfirmed elements</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>未確定の要素をすべて確定</translation>
  </message>
  <message>
   <source>Copied and unfinished elements count and are saved from now on</source>
   <extracomment>[the action confirm_all]</extracomment>
   <translation>コピーした要素と描きかけの要素が有効になり、以後保存されます</translation>
  </message>
  <message>
   <source>Drop unconfirmed elements</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>未確定の要素を捨てる</translation>
  </message>
  <message>
   <source>Remove copied and unfinished elements that were not edited</source>
   <extracomment>[the action drop_unconfirmed]</extracomment>
   <translation>編集していないコピーと描きかけの要素を取り除きます</translation>
  </message>
  <message>
   <source>Regularise all elements</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>すべての要素を整える</translation>
  </message>
  <message>
   <source>Resample every element of the frame along its painted line</source>
   <extracomment>[the action regularise_all]</extracomment>
   <translation>フレームの各要素を塗られた線に沿って取り直します</translation>
  </message>
  <message>
   <source>Draw</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>描く</translation>
  </message>
  <message>
   <source>Clicks add points to the chosen element</source>
   <extracomment>[the action draw_mode]</extracomment>
   <translation>クリックで選択中の要素に点を加えます</translation>
  </message>
  <message>
   <source>Drag, insert and remove points</source>
   <extracomment>[the action edit_mode]</extracomment>
   <translation>点を動かし、挿入し、取り除きます</translation>
  </message>
  <message>
   <source>Switch between draw and edit</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>描画と編集を切り替える</translation>
  </message>
  <message>
   <source>From drawing to editing and back</source>
   <extracomment>[the action switch_mode]</extracomment>
   <translation>描画から編集へ、またその逆へ</translation>
  </message>
  <message>
   <source>Next element</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>次の要素</translation>
  </message>
  <message>
   <source>Choose the next element of the field</source>
   <extracomment>[the action next_element]</extracomment>
   <translation>フィールドの次の要素を選びます</translation>
  </message>
  <message>
   <source>Previous element</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>前の要素</translation>
  </message>
  <message>
   <source>Choose the element before</source>
   <extracomment>[the action previous_element]</extracomment>
   <translation>前の要素を選びます</translation>
  </message>
  <message>
   <source>Find element…</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>要素を探す…</translation>
  </message>
  <message>
   <source>Type a part of the element's name</source>
   <extracomment>[the action find_element]</extracomment>
   <translation>要素名の一部を入力します</translation>
  </message>
  <message>
   <source>Finish element</source>
   <extracomment>[the action finish]</extracomment>
   <translation>要素を終える</translation>
  </message>
  <message>
   <source>Make the points just clicked an element (or double-click the last one)</source>
   <extracomment>[the action finish]</extracomment>
   <translation>クリックした点を要素にします（最後の点のダブルクリックでも可）</translation>
  </message>
  <message>
   <source>Finish and stay</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>終えてとどまる</translation>
  </message>
  <message>
   <source>Finish the element without going on to the next one</source>
   <extracomment>[the action finish_stay]</extracomment>
   <translation>次へ進まずに要素を終えます</translation>
  </message>
  <message>
   <source>Remove the last point</source>
   <extracomment>[the action back]</extracomment>
   <translation>最後の点を取り除く</translation>
  </message>
  <message>
   <source>Remove the point clicked last</source>
   <extracomment>[the action back]</extracomment>
   <translation>最後にクリックした点を取り除きます</translation>
  </message>
  <message>
   <source>Delete element</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>要素を削除</translation>
  </message>
  <message>
   <source>Remove the selected element with all its points</source>
   <extracomment>[the action delete_element]</extracomment>
   <translation>選択中の要素をすべての点とともに取り除きます</translation>
  </message>
  <message>
   <source>Confirm element</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>要素を確定</translation>
  </message>
  <message>
   <source>The selected element counts and is saved from now on (in edit mode: Enter)</source>
   <extracomment>[the action confirm]</extracomment>
   <translation>選択中の要素が有効になり、以後保存されます（編集中は Enter）</translation>
  </message>
  <message>
   <source>Regularise</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>整える</translation>
  </message>
  <message>
   <source>Resample the element along its painted line: two clicks make a straight element, five a curve</source>
   <extracomment>[the action regularise]</extracomment>
   <translation>塗られた線に沿って要素を取り直します：2 クリックで直線、5 クリックで曲線</translation>
  </message>
  <message>
   <source>Close gaps</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>すき間を閉じる</translation>
  </message>
  <message>
   <source>Let the element's ends reach the corner or the picture's edge they fall short of</source>
   <extracomment>[the action close_gaps]</extracomment>
   <translation>要素の端を、届いていない角や画像の縁まで延ばします</translation>
  </message>
  <message>
   <source>Reverse</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>向きを逆にする</translation>
  </message>
  <message>
   <source>Turn the order of the element's points round</source>
   <extracomment>[the action reverse]</extracomment>
   <translation>要素の点の順序を逆にします</translation>
  </message>
  <message>
   <source>Duplicate to the symmetric class</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>対称クラスへ複製</translation>
  </message>
  <message>
   <source>Put a copy under the class of the turned field, to be dragged to its place</source>
   <extracomment>[the action duplicate]</extracomment>
   <translation>回転したフィールドのクラスでコピーを置きます。所定の位置へ動かしてください</translation>
  </message>
  <message>
   <source>Snap to lines</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>線に吸着</translation>
  </message>
  <message>
   <source>Clicks near a painted line go to its centre (hold Ctrl to click off it)</source>
   <extracomment>[the action snapping, the setting snapping]</extracomment>
   <translation>塗られた線の近くのクリックはその中心に移ります（Ctrl を押すと線の横をクリック）</translation>
  </message>
  <message>
   <source>Go on to the next element</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>次の要素へ進む</translation>
  </message>
  <message>
   <source>After finishing an element, choose the one that most likely comes next</source>
   <extracomment>[the action auto_advance, the setting auto_advance]</extracomment>
   <translation>要素を終えたら、次に来る可能性が最も高い要素を選びます</translation>
  </message>
  <message>
   <source>Two clicks finish a straight element</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>直線は 2 クリックで終える</translation>
  </message>
  <message>
   <source>The second click on a straight element finishes it</source>
   <extracomment>[the action two_clicks, the setting two_clicks]</extracomment>
   <translation>直線の要素では 2 回目のクリックで終わります</translation>
  </message>
  <message>
   <source>Draw first, name after</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>先に描いて後で名付ける</translation>
  </message>
  <message>
   <source>Without an element chosen, a click begins a line; once it is finished, the likeliest elements are offered at the pen</source>
   <extracomment>[the action draw_first, the setting draw_first]</extracomment>
   <translation>要素を選ばずにクリックすると線が始まり、終えると最もありそうな要素がペンのそばに示されます</translation>
  </message>
  <message>
   <source>Pin elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>要素を固定</translation>
  </message>
  <message>
   <source>Only points can be dragged, no whole elements</source>
   <extracomment>[the action pinned, the setting pinned]</extracomment>
   <translation>動かせるのは点だけで、要素全体は動きません</translation>
  </message>
  <message>
   <source>Ghosts</source>
   <extracomment>[the menus]</extracomment>
   <translation>ゴースト</translation>
  </message>
  <message>
   <source>Next ghost</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>次のゴースト</translation>
  </message>
  <message>
   <source>Look closely at the next element the fitted camera expects</source>
   <extracomment>[the action next_ghost]</extracomment>
   <translation>当てはめたカメラが予想する次の要素を拡大して見ます</translation>
  </message>
  <message>
   <source>Previous ghost</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>前のゴースト</translation>
  </message>
  <message>
   <source>Look closely at the one before</source>
   <extracomment>[the action previous_ghost]</extracomment>
   <translation>前のものを拡大して見ます</translation>
  </message>
  <message>
   <source>Accept ghost</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>ゴーストを採用</translation>
  </message>
  <message>
   <source>Make the ghost an element: points on its painted line, none where that is hidden (Enter)</source>
   <extracomment>[the action accept_ghost]</extracomment>
   <translation>ゴーストを要素にします：塗られた線の上に点を置き、隠れた所には置きません（Enter）</translation>
  </message>
  <message>
   <source>Accept all ghosts</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>すべてのゴーストを採用</translation>
  </message>
  <message>
   <source>Accept all ghosts whose painted lines are seen well enough (Shift+Enter while nothing is being drawn)</source>
   <extracomment>[the action accept_ghosts]</extracomment>
   <translation>塗られた線が十分に見えるゴーストをすべて採用します（何も描いていないとき Shift+Enter）</translation>
  </message>
  <message>
   <source>Accept all and go on</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>すべて採用して次へ</translation>
  </message>
  <message>
   <source>Accept all ghosts of this frame and show the next one: one key a frame</source>
   <extracomment>[the action accept_go_on]</extracomment>
   <translation>このフレームのゴーストをすべて採用し、次を表示します：1 フレームに 1 キー</translation>
  </message>
  <message>
   <source>Line seen to accept all…</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>一括採用に必要な見え方…</translation>
  </message>
  <message>
   <source>How much of its painted line must be seen for a ghost to be accepted with all others</source>
   <extracomment>[the action ghost_support]</extracomment>
   <translation>ほかと一緒に採用するには、ゴーストの塗られた線がどれだけ見える必要があるか</translation>
  </message>
  <message>
   <source>The ghost or the chosen element cannot be seen in this frame; once more takes it back</source>
   <extracomment>[the action not_visible]</extracomment>
   <translation>ゴーストまたは選択中の要素はこのフレームで見えません。もう一度で取り消し</translation>
  </message>
  <message>
   <source>Take back “not visible here”</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>「ここでは見えない」を取り消す</translation>
  </message>
  <message>
   <source>The element said last to be not visible in this frame may be seen after all</source>
   <extracomment>[the action visible_again]</extracomment>
   <translation>このフレームで見えないとした最後の要素を、見えるかもしれないものに戻します</translation>
  </message>
  <message>
   <source>Show ghosts</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>ゴーストを表示</translation>
  </message>
  <message>
   <source>Draw faint curves where the fitted camera expects elements that are not annotated yet</source>
   <extracomment>[the action ghosts, the setting ghosts]</extracomment>
   <translation>まだ注釈のない要素の予想位置を淡い曲線で描きます</translation>
  </message>
  <message>
   <source>Look for the camera in the picture</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>画像からカメラを探す</translation>
  </message>
  <message>
   <source>Where nothing is annotated yet, find the camera without a click and show its elements as ghosts; nothing is saved before it is accepted</source>
   <extracomment>[the action propose, the setting propose]</extracomment>
   <translation>まだ何も注釈がないとき、クリックなしでカメラを求め、要素をゴーストで示します。採用するまで何も保存しません</translation>
  </message>
  <message>
   <source>Say what to annotate next</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>次に注釈するものを示す</translation>
  </message>
  <message>
   <source>Mark on the field map the element that would make the fitted camera surest</source>
   <extracomment>[the action suggest, the setting suggest]</extracomment>
   <translation>当てはめたカメラを最も確かにする要素をフィールド図に示します</translation>
  </message>
  <message>
   <source>Fit to window</source>
   <extracomment>[the action fit]</extracomment>
   <translation>ウィンドウに合わせる</translation>
  </message>
  <message>
   <source>Show the whole picture</source>
   <extracomment>[the action fit]</extracomment>
   <translation>画像全体を表示します</translation>
  </message>
  <message>
   <source>Actual size</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>原寸</translation>
  </message>
  <message>
   <source>One picture pixel is one screen pixel</source>
   <extracomment>[the action actual_size]</extracomment>
   <translation>画像の 1 ピクセルを画面の 1 ピクセルで表示します</translation>
  </message>
  <message>
   <source>Zoom in</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>拡大</translation>
  </message>
  <message>
   <source>Magnify (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_in]</extracomment>
   <translation>拡大します（マウスホイールではカーソル位置で）</translation>
  </message>
  <message>
   <source>Zoom out</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>縮小</translation>
  </message>
  <message>
   <source>Reduce (the mouse wheel does it at the cursor)</source>
   <extracomment>[the action zoom_out]</extracomment>
   <translation>縮小します（マウスホイールではカーソル位置で）</translation>
  </message>
  <message>
   <source>Pan</source>
   <extracomment>[the action pan]</extracomment>
   <translation>移動</translation>
  </message>
  <message>
   <source>The left button moves the picture (or hold Space, or the middle button); Esc ends it</source>
   <extracomment>[the action pan]</extracomment>
   <translation>左ボタンで画像を動かします（Space を押すか中ボタンでも可）。Esc で終わります</translation>
  </message>
  <message>
   <source>Keep zoom across frames</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>フレーム間で拡大を保つ</translation>
  </message>
  <message>
   <source>Stay at this place of the picture when the frame changes</source>
   <extracomment>[the action keep_zoom, the setting keep_zoom]</extracomment>
   <translation>フレームが変わっても画像の同じ場所にとどまります</translation>
  </message>
  <message>
   <source>Hide overlays</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>重ね描きを隠す</translation>
  </message>
  <message>
   <source>Show the bare picture (or hold X)</source>
   <extracomment>[the action hide_overlays]</extracomment>
   <translation>画像だけを表示します（X を押している間でも可）</translation>
  </message>
  <message>
   <source>Colour by</source>
   <extracomment>[the menus, the setting colour_by]</extracomment>
   <translation>色分け</translation>
  </message>
  <message>
   <source>Criterion</source>
   <extracomment>[the action colour_criterion, the setting colour_by]</extracomment>
   <translation>基準</translation>
  </message>
  <message>
   <source>Colours say how the camera is judged</source>
   <extracomment>[the action colour_criterion]</extracomment>
   <translation>色はカメラの評価を表します</translation>
  </message>
  <message>
   <source>Class</source>
   <extracomment>[the action colour_class, the setting colour_by]</extracomment>
   <translation>クラス</translation>
  </message>
  <message>
   <source>Every element in its own colour</source>
   <extracomment>[the action colour_class]</extracomment>
   <translation>要素ごとの色</translation>
  </message>
  <message>
   <source>Provenance</source>
   <extracomment>[the action colour_origin, the setting colour_by]</extracomment>
   <translation>来歴</translation>
  </message>
  <message>
   <source>Points by how they came to be: clicked, snapped, regularised, copied, moved</source>
   <extracomment>[the action colour_origin]</extracomment>
   <translation>点の作られ方：クリック、吸着、整形、コピー、移動</translation>
  </message>
  <message>
   <source>Annotator</source>
   <extracomment>[the action colour_annotator, the setting colour_by]</extracomment>
   <translation>注釈者</translation>
  </message>
  <message>
   <source>Points by who put them there</source>
   <extracomment>[the action colour_annotator]</extracomment>
   <translation>点を置いた人ごと</translation>
  </message>
  <message>
   <source>Painted width</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>塗りの幅</translation>
  </message>
  <message>
   <source>Draw how wide the field's lines must appear, along the projection</source>
   <extracomment>[the action painted_width, the setting painted_width]</extracomment>
   <translation>フィールドの線がどれだけの幅に見えるはずかを投影のそばに描きます</translation>
  </message>
  <message>
   <source>Evidence of paint</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>塗りの証拠</translation>
  </message>
  <message>
   <source>Beside every segment a strip: solid where the picture shows paint under it, dashed where paint runs beside it, on that side, dotted where there is none</source>
   <extracomment>[the action evidence, the setting evidence]</extracomment>
   <translation>各区間の横に帯を描きます：下に塗りが見えれば実線、横にずれていればその側に破線、なければ点線</translation>
  </message>
  <message>
   <source>Loupe</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>ルーペ</translation>
  </message>
  <message>
   <source>Keep the loupe at the cursor (or hold Z; it also comes while a point is dragged)</source>
   <extracomment>[the action loupe, the setting loupe]</extracomment>
   <translation>カーソルにルーペを出したままにします（Z を押す間も可。点を動かすときも現れます）</translation>
  </message>
  <message>
   <source>Legend in the picture</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>画像内の凡例</translation>
  </message>
  <message>
   <source>What the colours, dashes and marks over the picture mean, in its corner; it gives way to the hand</source>
   <extracomment>[the action legend, the setting legend]</extracomment>
   <translation>画像上の色、破線、記号の意味を画像の隅に示します。手が近づくと場所を譲ります</translation>
  </message>
  <message>
   <source>Turn the field map to the camera</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>フィールド図をカメラの向きに</translation>
  </message>
  <message>
   <source>The field map has the side below that the camera stands on, and what the camera does not see is faint</source>
   <extracomment>[the action turn_map, the setting turn_map]</extracomment>
   <translation>フィールド図の下側がカメラのある側になり、見えない部分は淡くなります</translation>
  </message>
  <message>
   <source>Picture on the field map</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>フィールドマップに画像を表示</translation>
  </message>
  <message>
   <source>Show the picture on the field map, as seen from above: lines that bend or miss the map's show where a camera is wrong</source>
   <extracomment>[the action top_view, the setting top_view]</extracomment>
   <translation>上から見た画像をフィールドマップに表示します。曲がった線やマップの線からずれた線は、カメラの誤りを示します</translation>
  </message>
  <message>
   <source>Strip of frames</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>フレームの帯</translation>
  </message>
  <message>
   <source>Below the picture: thumbnails of the frames, or the timeline of a video</source>
   <extracomment>[the action strip, the setting strip]</extracomment>
   <translation>画像の下：フレームのサムネイル、または動画のタイムライン</translation>
  </message>
  <message>
   <source>List of frames</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>フレームの一覧</translation>
  </message>
  <message>
   <source>Show the frames with their names and a filter at the left, instead of the strip; once more closes the list</source>
   <extracomment>[the action frames_list]</extracomment>
   <translation>帯の代わりに、左にフレームを名前とフィルター付きで表示します。もう一度で一覧を閉じます</translation>
  </message>
  <message>
   <source>Errors and JaC of the frame or the set, of all shown sources</source>
   <extracomment>[the action plots]</extracomment>
   <translation>フレームまたはセットの誤差と JaC（表示中の全ソース）</translation>
  </message>
  <message>
   <source>Panels to annotate</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>注釈用パネル</translation>
  </message>
  <message>
   <source>Elements, what the check found, landmarks</source>
   <extracomment>[the action desk_annotate]</extracomment>
   <translation>要素、検査の指摘、目印</translation>
  </message>
  <message>
   <source>Panels to judge</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>評価用パネル</translation>
  </message>
  <message>
   <source>Scores, camera sources, the fit, plots</source>
   <extracomment>[the action desk_judge]</extracomment>
   <translation>スコア、カメラソース、当てはめ、グラフ</translation>
  </message>
  <message>
   <source>Panels to review</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>レビュー用パネル</translation>
  </message>
  <message>
   <source>Status, comments and time, a second annotator</source>
   <extracomment>[the action desk_review]</extracomment>
   <translation>状態、コメントと時間、2 人目の注釈者</translation>
  </message>
  <message>
   <source>Hide all panels</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>すべてのパネルを隠す</translation>
  </message>
  <message>
   <source>Give the picture all the room</source>
   <extracomment>[the action hide_panels]</extracomment>
   <translation>画像を最大に表示します</translation>
  </message>
  <message>
   <source>Keyboard to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>キーボードをパネルへ</translation>
  </message>
  <message>
   <source>Tab goes through ghosts in the picture; this takes the keyboard on to the panels</source>
   <extracomment>[the action to_panels]</extracomment>
   <translation>画像では Tab がゴーストを巡ります。これでキーボードをパネルへ移します</translation>
  </message>
  <message>
   <source>Keyboard to the next part</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>キーボードを次の部分へ</translation>
  </message>
  <message>
   <source>Picture, panels, tool bar: the keyboard goes round them</source>
   <extracomment>[the action next_region]</extracomment>
   <translation>画像、パネル、バーをキーボードで巡ります</translation>
  </message>
  <message>
   <source>Keyboard to the part before</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>キーボードを前の部分へ</translation>
  </message>
  <message>
   <source>The same way round backwards</source>
   <extracomment>[the action previous_region]</extracomment>
   <translation>同じ巡りを逆方向に</translation>
  </message>
  <message>
   <source>Reset the layout</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>配置を元に戻す</translation>
  </message>
  <message>
   <source>Put the panels back where they were at first</source>
   <extracomment>[the action reset_layout]</extracomment>
   <translation>パネルを最初の位置に戻します</translation>
  </message>
  <message>
   <source>Load cameras…</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>カメラを読み込む…</translation>
  </message>
  <message>
   <source>Judge a folder of cameras or homographies against the annotations</source>
   <extracomment>[the action load_cameras]</extracomment>
   <translation>カメラまたはホモグラフィのフォルダーを注釈と照らして評価します</translation>
  </message>
  <message>
   <source>Load camera file…</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>カメラファイルを読み込む…</translation>
  </message>
  <message>
   <source>Judge a single camera file, or a zip of them</source>
   <extracomment>[the action load_camera_file]</extracomment>
   <translation>1 つのカメラファイル、またはその zip を評価します</translation>
  </message>
  <message>
   <source>Next camera source</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>次のカメラソース</translation>
  </message>
  <message>
   <source>Judge with the next of the loaded sources</source>
   <extracomment>[the action next_camera]</extracomment>
   <translation>読み込んだ次のソースで評価します</translation>
  </message>
  <message>
   <source>Previous camera source</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>前のカメラソース</translation>
  </message>
  <message>
   <source>Judge with the one before</source>
   <extracomment>[the action previous_camera]</extracomment>
   <translation>前のソースで評価します</translation>
  </message>
  <message>
   <source>Swap with the compared source</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>比較ソースと入れ替え</translation>
  </message>
  <message>
   <source>Judge with the source compared, and compare with this one (or tap the comma; hold it to look only)</source>
   <extracomment>[the action swap_cameras]</extracomment>
   <translation>比較中のソースで評価し、今のソースと比べます（コンマを押しても可。押し続けると見るだけ）</translation>
  </message>
  <message>
   <source>Draw other sources</source>
   <extracomment>[the action others]</extracomment>
   <translation>ほかのソースを描く</translation>
  </message>
  <message>
   <source>Draw the sources ticked in the Cameras panel as wireframes, with the active one</source>
   <extracomment>[the action others]</extracomment>
   <translation>カメラパネルで印を付けたソースを使用中のソースの横にワイヤーフレームで描きます</translation>
  </message>
  <message>
   <source>Split view</source>
   <extracomment>[the action split]</extracomment>
   <translation>分割表示</translation>
  </message>
  <message>
   <source>Draw the active source left of a divider, the compared one right of it</source>
   <extracomment>[the action split]</extracomment>
   <translation>仕切りの左に使用中のソース、右に比較ソースを描きます</translation>
  </message>
  <message>
   <source>How many metres apart the active and the compared source see each pixel on the ground</source>
   <extracomment>[the action disagreement]</extracomment>
   <translation>使用中と比較中のソースが地面の各ピクセルを何メートルずれて見るか</translation>
  </message>
  <message>
   <source>Uncertainty map</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>不確かさの地図</translation>
  </message>
  <message>
   <source>Where on the field the fitted camera is good to 0.1, 0.5 and 1 m</source>
   <extracomment>[the action uncertainty]</extracomment>
   <translation>当てはめたカメラがフィールドのどこで 0.1、0.5、1 m の精度か</translation>
  </message>
  <message>
   <source>Live fit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>自動当てはめ</translation>
  </message>
  <message>
   <source>Fit a camera to the clicks of the frame after every edit</source>
   <extracomment>[the action live_fit, the setting live_fit]</extracomment>
   <translation>編集のたびにフレームのクリックにカメラを当てはめます</translation>
  </message>
  <message>
   <source>Save fit as the frame's camera</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>当てはめをフレームのカメラとして保存</translation>
  </message>
  <message>
   <source>Write the camera fitted to the clicks into the folder cameras/fitted of the dataset</source>
   <extracomment>[the action save_fit]</extracomment>
   <translation>クリックに当てはめたカメラをデータセットの cameras/fitted フォルダーに書き出します</translation>
  </message>
  <message>
   <source>Field dimensions…</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>フィールドの寸法…</translation>
  </message>
  <message>
   <source>Length and width of this stadium's field, entered or found from all frames; and where on its lines the clicks lie</source>
   <extracomment>[the action field_dimensions]</extracomment>
   <translation>このスタジアムのフィールドの長さと幅（入力、または全フレームから推定）と、クリックが線のどこにあるか</translation>
  </message>
  <message>
   <source>Threshold up 0.5 px</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>しきい値を 0.5 px 上げる</translation>
  </message>
  <message>
   <source>Allow larger distances</source>
   <extracomment>[the action tau_up]</extracomment>
   <translation>より大きな距離を許します</translation>
  </message>
  <message>
   <source>Threshold down 0.5 px</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>しきい値を 0.5 px 下げる</translation>
  </message>
  <message>
   <source>Allow smaller distances only</source>
   <extracomment>[the action tau_down]</extracomment>
   <translation>より小さな距離だけを許します</translation>
  </message>
  <message>
   <source>soccernet</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>soccernet</translation>
  </message>
  <message>
   <source>The official SoccerNet evaluation, quirks included</source>
   <extracomment>[the action protocol_soccernet]</extracomment>
   <translation>SoccerNet の公式評価（その癖も含む）</translation>
  </message>
  <message>
   <source>procc</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>procc</translation>
  </message>
  <message>
   <source>The paper's definition, without the official code's artefacts</source>
   <extracomment>[the action protocol_procc]</extracomment>
   <translation>論文の定義。公式コードに由来する癖はありません</translation>
  </message>
  <message>
   <source>Elements off the ground</source>
   <extracomment>[the menus, the setting off_plane]</extracomment>
   <translation>地面にない要素</translation>
  </message>
  <message>
   <source>Count as missed</source>
   <extracomment>[the action off_plane_missed, the setting off_plane]</extracomment>
   <translation>見逃しとして数える</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project count against it</source>
   <extracomment>[the action off_plane_missed]</extracomment>
   <translation>ホモグラフィで投影できないゴール、リング、ネットは不利に数えられます</translation>
  </message>
  <message>
   <source>Goals, baskets and nets that a homography cannot project are not counted</source>
   <extracomment>[the action off_plane_left_out]</extracomment>
   <translation>ホモグラフィで投影できないゴール、リング、ネットは数えません</translation>
  </message>
  <message>
   <source>Camera wrong</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>カメラの誤り</translation>
  </message>
  <message>
   <source>The active camera is wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_camera]</extracomment>
   <translation>このフレームでは使用中のカメラが誤り。もう一度で判定を取り消し</translation>
  </message>
  <message>
   <source>Labels wrong</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>注釈の誤り</translation>
  </message>
  <message>
   <source>The clicks are wrong in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_annotation]</extracomment>
   <translation>このフレームではクリックが誤り。もう一度で判定を取り消し</translation>
  </message>
  <message>
   <source>OK</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>OK</translation>
  </message>
  <message>
   <source>Camera and clicks are right in this frame; once more takes the verdict back</source>
   <extracomment>[the action mark_fine]</extracomment>
   <translation>このフレームではカメラもクリックも正しい。もう一度で判定を取り消し</translation>
  </message>
  <message>
   <source>Note on the verdict…</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>判定へのメモ…</translation>
  </message>
  <message>
   <source>Say in a few words what is wrong; it is exported with the verdict</source>
   <extracomment>[the action verdict_note]</extracomment>
   <translation>何が誤りかを短く書きます。判定とともに書き出されます</translation>
  </message>
  <message>
   <source>Stop scoring the set</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>セットの採点を止める</translation>
  </message>
  <message>
   <source>Stop computing the JaC of the frames not opened yet, and comparing sources</source>
   <extracomment>[the action stop_scoring]</extracomment>
   <translation>まだ開いていないフレームの JaC の計算とソースの比較を止めます</translation>
  </message>
  <message>
   <source>Find anything…</source>
   <extracomment>[the action palette]</extracomment>
   <translation>何でも探す…</translation>
  </message>
  <message>
   <source>The command palette: every action, element, frame, camera source and recent folder, by a few letters of its name</source>
   <extracomment>[the action palette]</extracomment>
   <translation>コマンドパレット：操作、要素、フレーム、カメラソース、最近のフォルダーを名前の数文字で呼び出します</translation>
  </message>
  <message>
   <source>Draw, accept, check, judge and export, step by step, on a copy of the sample</source>
   <extracomment>[the action tour]</extracomment>
   <translation>描画、受け入れ、検査、評価、書き出しをサンプルの写しで順に試します</translation>
  </message>
  <message>
   <source>Show all actions and their keys on one sheet</source>
   <extracomment>[the action keys]</extracomment>
   <translation>すべての操作とそのキーを一覧で示します</translation>
  </message>
  <message>
   <source>Give actions and elements other keys, or take those of another program</source>
   <extracomment>[the action keymap]</extracomment>
   <translation>操作や要素に別のキーを割り当てるか、ほかのプログラムのキーを使います</translation>
  </message>
  <message>
   <source>The guide that comes with the program; it needs no network</source>
   <extracomment>[the action guide]</extracomment>
   <translation>プログラム付属のガイド。ネットワークは不要です</translation>
  </message>
  <message>
   <source>Copy details of the last error</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>最後のエラーの詳細をコピー</translation>
  </message>
  <message>
   <source>What an unexpected error left in the log, for a report to the maintainers</source>
   <extracomment>[the action copy_error]</extracomment>
   <translation>予期しないエラーがログに残した内容。開発者への報告用</translation>
  </message>
  <message>
   <source>Version</source>
   <extracomment>[the action about]</extracomment>
   <translation>バージョン</translation>
  </message>
  <message>
   <source>Appearance</source>
   <extracomment>[the setting colour_by, the setting font_percent, the setting language]</extracomment>
   <translation>外観</translation>
  </message>
  <message>
   <source>Theme</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>テーマ</translation>
  </message>
  <message>
   <source>Light, dark or system</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>明るい、暗い、またはシステムに合わせる</translation>
  </message>
  <message>
   <source>System</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>システム</translation>
  </message>
  <message>
   <source>Light</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>明るい</translation>
  </message>
  <message>
   <source>Dark</source>
   <extracomment>[the setting theme]</extracomment>
   <translation>暗い</translation>
  </message>
  <message>
   <source>Text size</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>文字の大きさ</translation>
  </message>
  <message>
   <source>Text size, % of system (after restart)</source>
   <extracomment>[the setting font_percent]</extracomment>
   <translation>文字の大きさ、システムに対する %（再起動後）</translation>
  </message>
  <message>
   <source>Language</source>
   <extracomment>[the setting language]</extracomment>
   <translation>言語</translation>
  </message>
  <message>
   <source>Language of the window (after restart); files stay as they are</source>
   <extracomment>[the setting language]</extracomment>
   <translation>ウィンドウの言語（再起動後）。ファイルは変わりません</translation>
  </message>
  <message>
   <source>What the colours over the picture say</source>
   <extracomment>[the setting colour_by]</extracomment>
   <translation>画像上の色が表すもの</translation>
  </message>
  <message>
   <source>Author name</source>
   <extracomment>[the setting author]</extracomment>
   <translation>作成者名</translation>
  </message>
  <message>
   <source>Author name (empty = login name)</source>
   <extracomment>[the setting author]</extracomment>
   <translation>作成者名（空 = ログイン名）</translation>
  </message>
  <message>
   <source>Judging</source>
   <extracomment>[the setting blind, the setting off_plane, the setting protocol]</extracomment>
   <translation>評価</translation>
  </message>
  <message>
   <source>Threshold</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>しきい値</translation>
  </message>
  <message>
   <source>How far an annotated point may be from its element, px of the evaluation size</source>
   <extracomment>[the setting tau]</extracomment>
   <translation>注釈点が要素から離れてよい距離（評価サイズの px）</translation>
  </message>
  <message>
   <source>How cameras are judged: as the official evaluation does, quirks included, or by the paper's definition</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>カメラの評価方法：癖も含めて公式評価どおり、または論文の定義</translation>
  </message>
  <message>
   <source>procc (the paper's)</source>
   <extracomment>[the setting protocol]</extracomment>
   <translation>procc（論文）</translation>
  </message>
  <message>
   <source>How elements count that a homography cannot project: goals, baskets, nets</source>
   <extracomment>[the setting off_plane]</extracomment>
   <translation>ホモグラフィで投影できない要素（ゴール、リング、ネット）の数え方</translation>
  </message>
  <message>
   <source>Model of the live fit</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>自動当てはめのモデル</translation>
  </message>
  <message>
   <source>The camera that is fitted to the clicks; auto: the simplest that they support</source>
   <extracomment>[the setting fit_model]</extracomment>
   <translation>クリックに当てはめるカメラ。auto：クリックが支える最も単純なもの</translation>
  </message>
  <message>
   <source>Judge the fit</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>当てはめを評価</translation>
  </message>
  <message>
   <source>Whether the fit is judged where nothing else is</source>
   <extracomment>[the setting judge_fit]</extracomment>
   <translation>ほかに何もないとき当てはめを評価するか</translation>
  </message>
  <message>
   <source>Line seen to accept all</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>一括採用に必要な見え方</translation>
  </message>
  <message>
   <source>How much of a ghost's line must be seen to accept it with all others</source>
   <extracomment>[the setting ghost_support]</extracomment>
   <translation>ほかのすべてと一緒に採用するには、ゴーストの線がどれだけ見える必要があるか</translation>
  </message>
  <message>
   <source>American football (NFL)</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>アメリカンフットボール（NFL）</translation>
  </message>
  <message>
   <source>Near sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>手前のサイドライン</translation>
  </message>
  <message>
   <source>Far sideline</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>奥のサイドライン</translation>
  </message>
  <message>
   <source>Near hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>手前のハッシュマーク</translation>
  </message>
  <message>
   <source>Far hash marks</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>奥のハッシュマーク</translation>
  </message>
  <message>
   <source>Left end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>左エンドライン</translation>
  </message>
  <message>
   <source>Left goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>左ゴールライン</translation>
  </message>
  <message>
   <source>Left 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 5 ヤードライン</translation>
  </message>
  <message>
   <source>Left 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 10 ヤードライン</translation>
  </message>
  <message>
   <source>Left 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 15 ヤードライン</translation>
  </message>
  <message>
   <source>Left 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 20 ヤードライン</translation>
  </message>
  <message>
   <source>Left 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 25 ヤードライン</translation>
  </message>
  <message>
   <source>Left 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 30 ヤードライン</translation>
  </message>
  <message>
   <source>Left 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 35 ヤードライン</translation>
  </message>
  <message>
   <source>Left 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 40 ヤードライン</translation>
  </message>
  <message>
   <source>Left 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左 45 ヤードライン</translation>
  </message>
  <message>
   <source>50-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>50 ヤードライン</translation>
  </message>
  <message>
   <source>Right end line</source>
   <extracomment>[the field american_football, the field volleyball]</extracomment>
   <translation>右エンドライン</translation>
  </message>
  <message>
   <source>Right goal line</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>右ゴールライン</translation>
  </message>
  <message>
   <source>Right 5-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 5 ヤードライン</translation>
  </message>
  <message>
   <source>Right 10-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 10 ヤードライン</translation>
  </message>
  <message>
   <source>Right 15-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 15 ヤードライン</translation>
  </message>
  <message>
   <source>Right 20-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 20 ヤードライン</translation>
  </message>
  <message>
   <source>Right 25-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 25 ヤードライン</translation>
  </message>
  <message>
   <source>Right 30-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 30 ヤードライン</translation>
  </message>
  <message>
   <source>Right 35-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 35 ヤードライン</translation>
  </message>
  <message>
   <source>Right 40-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 40 ヤードライン</translation>
  </message>
  <message>
   <source>Right 45-yard line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右 45 ヤードライン</translation>
  </message>
  <message>
   <source>Left crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>左クロスバー</translation>
  </message>
  <message>
   <source>Left goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左ゴールの左ポール</translation>
  </message>
  <message>
   <source>Left goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左ゴールの右ポール</translation>
  </message>
  <message>
   <source>Right crossbar</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>右クロスバー</translation>
  </message>
  <message>
   <source>Right goal left upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右ゴールの左ポール</translation>
  </message>
  <message>
   <source>Right goal right upright</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右ゴールの右ポール</translation>
  </message>
  <message>
   <source>Left try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左トライマーク</translation>
  </message>
  <message>
   <source>Right try mark</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右トライマーク</translation>
  </message>
  <message>
   <source>Length with both end zones</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>両エンドゾーンを含む長さ</translation>
  </message>
  <message>
   <source>Width</source>
   <extracomment>[the field american_football, the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>幅</translation>
  </message>
  <message>
   <source>Depth of an end zone</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>エンドゾーンの奥行き</translation>
  </message>
  <message>
   <source>Yard</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>ヤード</translation>
  </message>
  <message>
   <source>Yard line to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>ヤードラインからサイドラインまで</translation>
  </message>
  <message>
   <source>Hash marks to sideline</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>ハッシュマークからサイドラインまで</translation>
  </message>
  <message>
   <source>Try mark to goal line</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>トライマークからゴールラインまで</translation>
  </message>
  <message>
   <source>Try mark length</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>トライマークの長さ</translation>
  </message>
  <message>
   <source>Goal width</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>ゴールの幅</translation>
  </message>
  <message>
   <source>Crossbar height</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>クロスバーの高さ</translation>
  </message>
  <message>
   <source>Uprights above the crossbar</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>クロスバーより上のポール</translation>
  </message>
  <message>
   <source>Line width</source>
   <extracomment>[the field american_football, the field athletics, the field basketball_fiba]</extracomment>
   <translation>線の幅</translation>
  </message>
  <message>
   <source>Goal line width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>ゴールラインの幅</translation>
  </message>
  <message>
   <source>Border width</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>境界の幅</translation>
  </message>
  <message>
   <source>Left half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>左半分</translation>
  </message>
  <message>
   <source>Right half</source>
   <extracomment>[the field american_football]</extracomment>
   <translation>右半分</translation>
  </message>
  <message>
   <source>Left goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>左ゴール</translation>
  </message>
  <message>
   <source>Right goal</source>
   <extracomment>[the field american_football, the field futsal, the field handball]</extracomment>
   <translation>右ゴール</translation>
  </message>
  <message>
   <source>Athletics (400 m track)</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>陸上競技（400 m トラック）</translation>
  </message>
  <message>
   <source>Kerb</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>縁石</translation>
  </message>
  <message>
   <source>Lane line 1 | 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの線 1 | 2</translation>
  </message>
  <message>
   <source>Lane line 2 | 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの線 2 | 3</translation>
  </message>
  <message>
   <source>Lane line 3 | 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの線 3 | 4</translation>
  </message>
  <message>
   <source>Lane line 4 | 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの線 4 | 5</translation>
  </message>
  <message>
   <source>Lane line 5 | 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの線 5 | 6</translation>
  </message>
  <message>
   <source>Lane line 6 | 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの線 6 | 7</translation>
  </message>
  <message>
   <source>Lane line 7 | 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの線 7 | 8</translation>
  </message>
  <message>
   <source>Lane 8, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーン 8 の外側</translation>
  </message>
  <message>
   <source>Lane 9, outer edge</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーン 9 の外側</translation>
  </message>
  <message>
   <source>Finish line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>フィニッシュライン</translation>
  </message>
  <message>
   <source>100 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>100 m スタート</translation>
  </message>
  <message>
   <source>110 m hurdles start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>110 m ハードルのスタート</translation>
  </message>
  <message>
   <source>3000 m and 5000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>3000 m・5000 m スタート</translation>
  </message>
  <message>
   <source>10,000 m start</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>10,000 m スタート</translation>
  </message>
  <message>
   <source>Break line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>ブレークライン</translation>
  </message>
  <message>
   <source>200 m start, lane 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 1</translation>
  </message>
  <message>
   <source>200 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 2</translation>
  </message>
  <message>
   <source>200 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 3</translation>
  </message>
  <message>
   <source>200 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 4</translation>
  </message>
  <message>
   <source>200 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 5</translation>
  </message>
  <message>
   <source>200 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 6</translation>
  </message>
  <message>
   <source>200 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 7</translation>
  </message>
  <message>
   <source>200 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 8</translation>
  </message>
  <message>
   <source>200 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m スタート、レーン 9</translation>
  </message>
  <message>
   <source>400 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 2</translation>
  </message>
  <message>
   <source>400 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 3</translation>
  </message>
  <message>
   <source>400 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 4</translation>
  </message>
  <message>
   <source>400 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 5</translation>
  </message>
  <message>
   <source>400 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 6</translation>
  </message>
  <message>
   <source>400 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 7</translation>
  </message>
  <message>
   <source>400 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 8</translation>
  </message>
  <message>
   <source>400 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m スタート、レーン 9</translation>
  </message>
  <message>
   <source>800 m start, lane 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 2</translation>
  </message>
  <message>
   <source>800 m start, lane 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 3</translation>
  </message>
  <message>
   <source>800 m start, lane 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 4</translation>
  </message>
  <message>
   <source>800 m start, lane 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 5</translation>
  </message>
  <message>
   <source>800 m start, lane 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 6</translation>
  </message>
  <message>
   <source>800 m start, lane 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 7</translation>
  </message>
  <message>
   <source>800 m start, lane 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 8</translation>
  </message>
  <message>
   <source>800 m start, lane 9</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m スタート、レーン 9</translation>
  </message>
  <message>
   <source>Sprint track kerb line</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の内側の線</translation>
  </message>
  <message>
   <source>Sprint track line 1</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 1</translation>
  </message>
  <message>
   <source>Sprint track line 2</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 2</translation>
  </message>
  <message>
   <source>Sprint track line 3</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 3</translation>
  </message>
  <message>
   <source>Sprint track line 4</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 4</translation>
  </message>
  <message>
   <source>Sprint track line 5</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 5</translation>
  </message>
  <message>
   <source>Sprint track line 6</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 6</translation>
  </message>
  <message>
   <source>Sprint track line 7</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 7</translation>
  </message>
  <message>
   <source>Sprint track line 8</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路の線 8</translation>
  </message>
  <message>
   <source>Length over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>8 レーンでの長さ</translation>
  </message>
  <message>
   <source>Width over eight lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>8 レーンでの幅</translation>
  </message>
  <message>
   <source>Lane width</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーンの幅</translation>
  </message>
  <message>
   <source>Lanes</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>レーン</translation>
  </message>
  <message>
   <source>Finish and starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>フィニッシュとスタート</translation>
  </message>
  <message>
   <source>200 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>200 m のスタート</translation>
  </message>
  <message>
   <source>400 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>400 m のスタート</translation>
  </message>
  <message>
   <source>800 m starts</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>800 m のスタート</translation>
  </message>
  <message>
   <source>Sprint track</source>
   <extracomment>[the field athletics]</extracomment>
   <translation>直走路</translation>
  </message>
  <message>
   <source>Basketball (FIBA)</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>バスケットボール（FIBA）</translation>
  </message>
  <message>
   <source>Right endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右エンドライン</translation>
  </message>
  <message>
   <source>Left endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左エンドライン</translation>
  </message>
  <message>
   <source>Centre line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>センターライン</translation>
  </message>
  <message>
   <source>Centre circle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>センターサークル</translation>
  </message>
  <message>
   <source>Left key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左制限区域の奥側</translation>
  </message>
  <message>
   <source>Left free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>左フリースローライン</translation>
  </message>
  <message>
   <source>Left key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左制限区域の手前側</translation>
  </message>
  <message>
   <source>Left free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>左フリースロー半円</translation>
  </message>
  <message>
   <source>Right key far side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右制限区域の奥側</translation>
  </message>
  <message>
   <source>Right free-throw line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>右フリースローライン</translation>
  </message>
  <message>
   <source>Right key near side</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右制限区域の手前側</translation>
  </message>
  <message>
   <source>Right free-throw semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>右フリースロー半円</translation>
  </message>
  <message>
   <source>Left three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左スリーポイントの弧</translation>
  </message>
  <message>
   <source>Left three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左スリーポイント奥の直線</translation>
  </message>
  <message>
   <source>Left three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左スリーポイント手前の直線</translation>
  </message>
  <message>
   <source>Right three-point arc</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右スリーポイントの弧</translation>
  </message>
  <message>
   <source>Right three-point far straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右スリーポイント奥の直線</translation>
  </message>
  <message>
   <source>Right three-point near straight</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右スリーポイント手前の直線</translation>
  </message>
  <message>
   <source>Left backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左バックボード</translation>
  </message>
  <message>
   <source>Left rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左リング</translation>
  </message>
  <message>
   <source>Left no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>左ノーチャージ半円</translation>
  </message>
  <message>
   <source>Right backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右バックボード</translation>
  </message>
  <message>
   <source>Right rim</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右リング</translation>
  </message>
  <message>
   <source>Right no-charge semicircle</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>右ノーチャージ半円</translation>
  </message>
  <message>
   <source>Left backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左バックボードの四角</translation>
  </message>
  <message>
   <source>Left rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左リングの中心</translation>
  </message>
  <message>
   <source>Right backboard's rectangle</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右バックボードの四角</translation>
  </message>
  <message>
   <source>Right rim centre</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右リングの中心</translation>
  </message>
  <message>
   <source>Length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field futsal]</extracomment>
   <translation>長さ</translation>
  </message>
  <message>
   <source>Centre line beyond the sidelines</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>サイドラインの外のセンターライン</translation>
  </message>
  <message>
   <source>Circle radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field soccer]</extracomment>
   <translation>円の半径</translation>
  </message>
  <message>
   <source>Key length</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>制限区域の長さ</translation>
  </message>
  <message>
   <source>Key width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>制限区域の幅</translation>
  </message>
  <message>
   <source>Three-point radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>スリーポイントの半径</translation>
  </message>
  <message>
   <source>Three-point line to sideline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>スリーポイントラインからサイドラインまで</translation>
  </message>
  <message>
   <source>No-charge radius</source>
   <extracomment>[the field basketball_fiba]</extracomment>
   <translation>ノーチャージの半径</translation>
  </message>
  <message>
   <source>Backboard to endline</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>バックボードからエンドラインまで</translation>
  </message>
  <message>
   <source>Backboard width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>バックボードの幅</translation>
  </message>
  <message>
   <source>Backboard height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>バックボードの高さ</translation>
  </message>
  <message>
   <source>Backboard's lower edge</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>バックボードの下端</translation>
  </message>
  <message>
   <source>Backboard rectangle width</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>バックボードの四角の幅</translation>
  </message>
  <message>
   <source>Backboard rectangle height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>バックボードの四角の高さ</translation>
  </message>
  <message>
   <source>Rim height</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>リングの高さ</translation>
  </message>
  <message>
   <source>Rim radius</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>リングの半径</translation>
  </message>
  <message>
   <source>Rim to backboard</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>リングからバックボードまで</translation>
  </message>
  <message>
   <source>Court</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba, the field handball]</extracomment>
   <translation>コート</translation>
  </message>
  <message>
   <source>Left key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左制限区域</translation>
  </message>
  <message>
   <source>Right key</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右制限区域</translation>
  </message>
  <message>
   <source>Left three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左スリーポイントライン</translation>
  </message>
  <message>
   <source>Right three-point line</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右スリーポイントライン</translation>
  </message>
  <message>
   <source>Left basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>左バスケット</translation>
  </message>
  <message>
   <source>Right basket</source>
   <extracomment>[the field basketball_fiba, the field basketball_nba]</extracomment>
   <translation>右バスケット</translation>
  </message>
  <message>
   <source>Basketball (NBA)</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>バスケットボール（NBA）</translation>
  </message>
  <message>
   <source>Left free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左フリースローサークル</translation>
  </message>
  <message>
   <source>Right free-throw circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右フリースローサークル</translation>
  </message>
  <message>
   <source>Left restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左リストリクテッドエリアの弧</translation>
  </message>
  <message>
   <source>Right restricted area arc</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右リストリクテッドエリアの弧</translation>
  </message>
  <message>
   <source>Inner centre circle</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>内側のセンターサークル</translation>
  </message>
  <message>
   <source>Left far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左奥のハッシュマーク</translation>
  </message>
  <message>
   <source>Right far hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右奥のハッシュマーク</translation>
  </message>
  <message>
   <source>Left near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>左手前のハッシュマーク</translation>
  </message>
  <message>
   <source>Right near hash mark</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>右手前のハッシュマーク</translation>
  </message>
  <message>
   <source>Inner circle radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>内側の円の半径</translation>
  </message>
  <message>
   <source>Restricted area radius</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>リストリクテッドエリアの半径</translation>
  </message>
  <message>
   <source>Hash mark to endline</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>ハッシュマークからエンドラインまで</translation>
  </message>
  <message>
   <source>Hash mark length</source>
   <extracomment>[the field basketball_nba]</extracomment>
   <translation>ハッシュマークの長さ</translation>
  </message>
  <message>
   <source>Futsal</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>フットサル</translation>
  </message>
  <message>
   <source>Near touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>手前タッチライン</translation>
  </message>
  <message>
   <source>Far touchline</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>奥タッチライン</translation>
  </message>
  <message>
   <source>Halfway line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>ハーフウェーライン</translation>
  </message>
  <message>
   <source>Left penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>左ペナルティーエリアの線</translation>
  </message>
  <message>
   <source>Right penalty area line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>右ペナルティーエリアの線</translation>
  </message>
  <message>
   <source>Left goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>左ゴールの奥のポスト</translation>
  </message>
  <message>
   <source>Left goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>左ゴールの手前のポスト</translation>
  </message>
  <message>
   <source>Right goal far post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>右ゴールの奥のポスト</translation>
  </message>
  <message>
   <source>Right goal near post</source>
   <extracomment>[the field futsal, the field handball]</extracomment>
   <translation>右ゴールの手前のポスト</translation>
  </message>
  <message>
   <source>Centre mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>センターマーク</translation>
  </message>
  <message>
   <source>Left penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左ペナルティーマーク</translation>
  </message>
  <message>
   <source>Left second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>左第 2 ペナルティーマーク</translation>
  </message>
  <message>
   <source>Right penalty mark</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右ペナルティーマーク</translation>
  </message>
  <message>
   <source>Right second penalty mark</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>右第 2 ペナルティーマーク</translation>
  </message>
  <message>
   <source>Left far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左奥のコーナーアーク</translation>
  </message>
  <message>
   <source>Left near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左手前のコーナーアーク</translation>
  </message>
  <message>
   <source>Right far corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右奥のコーナーアーク</translation>
  </message>
  <message>
   <source>Right near corner arc</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右手前のコーナーアーク</translation>
  </message>
  <message>
   <source>Far substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>奥の交代ゾーン、左外</translation>
  </message>
  <message>
   <source>Far substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>奥の交代ゾーン、左内</translation>
  </message>
  <message>
   <source>Far substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>奥の交代ゾーン、右内</translation>
  </message>
  <message>
   <source>Far substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>奥の交代ゾーン、右外</translation>
  </message>
  <message>
   <source>Near substitution zone, left outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>手前の交代ゾーン、左外</translation>
  </message>
  <message>
   <source>Near substitution zone, left inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>手前の交代ゾーン、左内</translation>
  </message>
  <message>
   <source>Near substitution zone, right inner</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>手前の交代ゾーン、右内</translation>
  </message>
  <message>
   <source>Near substitution zone, right outer</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>手前の交代ゾーン、右外</translation>
  </message>
  <message>
   <source>Goalpost width</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>ゴールポストの幅</translation>
  </message>
  <message>
   <source>Penalty area radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>ペナルティーエリアの半径</translation>
  </message>
  <message>
   <source>Penalty mark to goal line</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>ペナルティーマークからゴールラインまで</translation>
  </message>
  <message>
   <source>Second penalty mark to goal line</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>第 2 ペナルティーマークからゴールラインまで</translation>
  </message>
  <message>
   <source>Centre circle radius</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>センターサークルの半径</translation>
  </message>
  <message>
   <source>Corner arc radius</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>コーナーアークの半径</translation>
  </message>
  <message>
   <source>Goal height</source>
   <extracomment>[the field futsal, the field handball, the field ice_hockey_iihf]</extracomment>
   <translation>ゴールの高さ</translation>
  </message>
  <message>
   <source>Pitch</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>ピッチ</translation>
  </message>
  <message>
   <source>Left penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>左ペナルティーエリア</translation>
  </message>
  <message>
   <source>Right penalty area</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>右ペナルティーエリア</translation>
  </message>
  <message>
   <source>Marks</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>マーク</translation>
  </message>
  <message>
   <source>Corners</source>
   <extracomment>[the field futsal, the field soccer]</extracomment>
   <translation>コーナー</translation>
  </message>
  <message>
   <source>Substitution zones</source>
   <extracomment>[the field futsal]</extracomment>
   <translation>交代ゾーン</translation>
  </message>
  <message>
   <source>Handball</source>
   <extracomment>[the field handball]</extracomment>
   <translation>ハンドボール</translation>
  </message>
  <message>
   <source>Near side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>手前のサイドライン</translation>
  </message>
  <message>
   <source>Far side line</source>
   <extracomment>[the field handball, the field volleyball]</extracomment>
   <translation>奥のサイドライン</translation>
  </message>
  <message>
   <source>Throw-off area</source>
   <extracomment>[the field handball]</extracomment>
   <translation>スローオフエリア</translation>
  </message>
  <message>
   <source>Left goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>左ゴールエリアライン</translation>
  </message>
  <message>
   <source>Left 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>左 7 メートルライン</translation>
  </message>
  <message>
   <source>Left 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>左 4 メートルライン</translation>
  </message>
  <message>
   <source>Right goal-area line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>右ゴールエリアライン</translation>
  </message>
  <message>
   <source>Right 7-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>右 7 メートルライン</translation>
  </message>
  <message>
   <source>Right 4-metre line</source>
   <extracomment>[the field handball]</extracomment>
   <translation>右 4 メートルライン</translation>
  </message>
  <message>
   <source>Far substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>奥の交代ライン、左</translation>
  </message>
  <message>
   <source>Far substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>奥の交代ライン、右</translation>
  </message>
  <message>
   <source>Near substitution line, left</source>
   <extracomment>[the field handball]</extracomment>
   <translation>手前の交代ライン、左</translation>
  </message>
  <message>
   <source>Near substitution line, right</source>
   <extracomment>[the field handball]</extracomment>
   <translation>手前の交代ライン、右</translation>
  </message>
  <message>
   <source>Goal area radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>ゴールエリアの半径</translation>
  </message>
  <message>
   <source>Free-throw line radius</source>
   <extracomment>[the field handball]</extracomment>
   <translation>フリースローラインの半径</translation>
  </message>
  <message>
   <source>Left goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>左ゴールエリア</translation>
  </message>
  <message>
   <source>Right goal area</source>
   <extracomment>[the field handball, the field soccer]</extracomment>
   <translation>右ゴールエリア</translation>
  </message>
  <message>
   <source>Substitution lines</source>
   <extracomment>[the field handball]</extracomment>
   <translation>交代ライン</translation>
  </message>
  <message>
   <source>Ice hockey (IIHF)</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>アイスホッケー（IIHF）</translation>
  </message>
  <message>
   <source>Near side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前のサイドボード</translation>
  </message>
  <message>
   <source>Far side boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥のサイドボード</translation>
  </message>
  <message>
   <source>Left end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左エンドボード</translation>
  </message>
  <message>
   <source>Right end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右エンドボード</translation>
  </message>
  <message>
   <source>Near left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の左コーナー</translation>
  </message>
  <message>
   <source>Far left corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の左コーナー</translation>
  </message>
  <message>
   <source>Near right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の右コーナー</translation>
  </message>
  <message>
   <source>Far right corner</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の右コーナー</translation>
  </message>
  <message>
   <source>Left blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左ブルーライン</translation>
  </message>
  <message>
   <source>Right blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右ブルーライン</translation>
  </message>
  <message>
   <source>Near left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の左サークル</translation>
  </message>
  <message>
   <source>Far left circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の左サークル</translation>
  </message>
  <message>
   <source>Near right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の右サークル</translation>
  </message>
  <message>
   <source>Far right circle</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の右サークル</translation>
  </message>
  <message>
   <source>Left goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左ゴールクリーズ</translation>
  </message>
  <message>
   <source>Left goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>左ゴール、左ポスト</translation>
  </message>
  <message>
   <source>Left goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>左ゴール、右ポスト</translation>
  </message>
  <message>
   <source>Right goal crease</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右ゴールクリーズ</translation>
  </message>
  <message>
   <source>Right goal left post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>右ゴール、左ポスト</translation>
  </message>
  <message>
   <source>Right goal right post</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl, the field soccer]</extracomment>
   <translation>右ゴール、右ポスト</translation>
  </message>
  <message>
   <source>Left trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左トラペゾイド、手前</translation>
  </message>
  <message>
   <source>Left trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左トラペゾイド、奥</translation>
  </message>
  <message>
   <source>Right trapezoid near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右トラペゾイド、手前</translation>
  </message>
  <message>
   <source>Right trapezoid far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右トラペゾイド、奥</translation>
  </message>
  <message>
   <source>Referee crease near</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前のレフェリークリーズ</translation>
  </message>
  <message>
   <source>Referee crease far</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥のレフェリークリーズ</translation>
  </message>
  <message>
   <source>Centre spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>センタースポット</translation>
  </message>
  <message>
   <source>Near left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の左エンドスポット</translation>
  </message>
  <message>
   <source>Far left end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の左エンドスポット</translation>
  </message>
  <message>
   <source>Near right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の右エンドスポット</translation>
  </message>
  <message>
   <source>Far right end spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の右エンドスポット</translation>
  </message>
  <message>
   <source>Near left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の左ニュートラルスポット</translation>
  </message>
  <message>
   <source>Far left neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の左ニュートラルスポット</translation>
  </message>
  <message>
   <source>Near right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の右ニュートラルスポット</translation>
  </message>
  <message>
   <source>Far right neutral spot</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の右ニュートラルスポット</translation>
  </message>
  <message>
   <source>Near boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前のボードの上端</translation>
  </message>
  <message>
   <source>Far boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥のボードの上端</translation>
  </message>
  <message>
   <source>Left boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>左のボードの上端</translation>
  </message>
  <message>
   <source>Right boards top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>右のボードの上端</translation>
  </message>
  <message>
   <source>Near left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の左コーナーの上端</translation>
  </message>
  <message>
   <source>Far left corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の左コーナーの上端</translation>
  </message>
  <message>
   <source>Near right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>手前の右コーナーの上端</translation>
  </message>
  <message>
   <source>Far right corner top edge</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>奥の右コーナーの上端</translation>
  </message>
  <message>
   <source>Corner radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>コーナーの半径</translation>
  </message>
  <message>
   <source>Height of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ボードの高さ</translation>
  </message>
  <message>
   <source>Goal line to end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ゴールラインからエンドボードまで</translation>
  </message>
  <message>
   <source>Blue line to end boards</source>
   <extracomment>[the field ice_hockey_iihf]</extracomment>
   <translation>ブルーラインからエンドボードまで</translation>
  </message>
  <message>
   <source>Face-off circle radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>フェイスオフサークルの半径</translation>
  </message>
  <message>
   <source>End spot to goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>エンドスポットからゴールラインまで</translation>
  </message>
  <message>
   <source>Neutral spot to blue line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ニュートラルスポットからブルーラインまで</translation>
  </message>
  <message>
   <source>Spot to the long axis</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>スポットから長軸まで</translation>
  </message>
  <message>
   <source>Goal crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ゴールクリーズの半径</translation>
  </message>
  <message>
   <source>Goal crease width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ゴールクリーズの幅</translation>
  </message>
  <message>
   <source>Referee crease radius</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>レフェリークリーズの半径</translation>
  </message>
  <message>
   <source>Trapezoid at the goal line</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ゴールラインでのトラペゾイド</translation>
  </message>
  <message>
   <source>Trapezoid at the end boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>エンドボードでのトラペゾイド</translation>
  </message>
  <message>
   <source>Blue and centre line width</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ブルーラインとセンターラインの幅</translation>
  </message>
  <message>
   <source>Boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ボード</translation>
  </message>
  <message>
   <source>Lines</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>線</translation>
  </message>
  <message>
   <source>Face-off circles</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>フェイスオフサークル</translation>
  </message>
  <message>
   <source>Face-off spots</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>フェイスオフスポット</translation>
  </message>
  <message>
   <source>Top of the boards</source>
   <extracomment>[the field ice_hockey_iihf, the field ice_hockey_nhl]</extracomment>
   <translation>ボードの上端</translation>
  </message>
  <message>
   <source>Ice hockey (NHL)</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>アイスホッケー（NHL）</translation>
  </message>
  <message>
   <source>Blue line to goal line</source>
   <extracomment>[the field ice_hockey_nhl]</extracomment>
   <translation>ブルーラインからゴールラインまで</translation>
  </message>
  <message>
   <source>Soccer</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>サッカー</translation>
  </message>
  <message>
   <source>Left penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左ペナルティーエリア、手前</translation>
  </message>
  <message>
   <source>Left penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左ペナルティーエリア、正面</translation>
  </message>
  <message>
   <source>Left penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左ペナルティーエリア、奥</translation>
  </message>
  <message>
   <source>Right penalty near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右ペナルティーエリア、手前</translation>
  </message>
  <message>
   <source>Right penalty front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右ペナルティーエリア、正面</translation>
  </message>
  <message>
   <source>Right penalty far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右ペナルティーエリア、奥</translation>
  </message>
  <message>
   <source>Left penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左ペナルティーアーク</translation>
  </message>
  <message>
   <source>Right penalty arc</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右ペナルティーアーク</translation>
  </message>
  <message>
   <source>Left goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左ゴールエリア、手前</translation>
  </message>
  <message>
   <source>Left goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左ゴールエリア、正面</translation>
  </message>
  <message>
   <source>Left goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左ゴールエリア、奥</translation>
  </message>
  <message>
   <source>Right goal area near</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右ゴールエリア、手前</translation>
  </message>
  <message>
   <source>Right goal area front</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右ゴールエリア、正面</translation>
  </message>
  <message>
   <source>Right goal area far</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右ゴールエリア、奥</translation>
  </message>
  <message>
   <source>Left far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左奥のコーナーフラッグ（根元）</translation>
  </message>
  <message>
   <source>Left near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>左手前のコーナーフラッグ（根元）</translation>
  </message>
  <message>
   <source>Right far corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右奥のコーナーフラッグ（根元）</translation>
  </message>
  <message>
   <source>Right near corner flag (foot)</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>右手前のコーナーフラッグ（根元）</translation>
  </message>
  <message>
   <source>Penalty area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>ペナルティーエリアの奥行き</translation>
  </message>
  <message>
   <source>Penalty area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>ペナルティーエリアの幅</translation>
  </message>
  <message>
   <source>Goal area depth</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>ゴールエリアの奥行き</translation>
  </message>
  <message>
   <source>Goal area width</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>ゴールエリアの幅</translation>
  </message>
  <message>
   <source>Goal unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>不明なゴール</translation>
  </message>
  <message>
   <source>Line unknown</source>
   <extracomment>[the field soccer]</extracomment>
   <translation>不明な線</translation>
  </message>
  <message>
   <source>Tennis</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>テニス</translation>
  </message>
  <message>
   <source>Left baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>左ベースライン</translation>
  </message>
  <message>
   <source>Right baseline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>右ベースライン</translation>
  </message>
  <message>
   <source>Far doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>奥のダブルスサイドライン</translation>
  </message>
  <message>
   <source>Near doubles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>手前のダブルスサイドライン</translation>
  </message>
  <message>
   <source>Far singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>奥のシングルスサイドライン</translation>
  </message>
  <message>
   <source>Near singles sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>手前のシングルスサイドライン</translation>
  </message>
  <message>
   <source>Left service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>左サービスライン</translation>
  </message>
  <message>
   <source>Right service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>右サービスライン</translation>
  </message>
  <message>
   <source>Centre service line</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>センターサービスライン</translation>
  </message>
  <message>
   <source>Net's top</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>ネットの上端</translation>
  </message>
  <message>
   <source>Far net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>奥のネットポスト</translation>
  </message>
  <message>
   <source>Near net post</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>手前のネットポスト</translation>
  </message>
  <message>
   <source>Net's centre strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>センターストラップ</translation>
  </message>
  <message>
   <source>Far singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>奥のシングルススティック</translation>
  </message>
  <message>
   <source>Near singles stick</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>手前のシングルススティック</translation>
  </message>
  <message>
   <source>Left centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>左センターマーク</translation>
  </message>
  <message>
   <source>Right centre mark</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>右センターマーク</translation>
  </message>
  <message>
   <source>Singles width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>シングルスの幅</translation>
  </message>
  <message>
   <source>Service line to net</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>サービスラインからネットまで</translation>
  </message>
  <message>
   <source>Baseline width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>ベースラインの幅</translation>
  </message>
  <message>
   <source>Centre line width</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>センターラインの幅</translation>
  </message>
  <message>
   <source>Centre mark length</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>センターマークの長さ</translation>
  </message>
  <message>
   <source>Net height at the strap</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>ストラップでのネットの高さ</translation>
  </message>
  <message>
   <source>Net height at the posts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>ポストでのネットの高さ</translation>
  </message>
  <message>
   <source>Net height at the singles sticks</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>シングルススティックでのネットの高さ</translation>
  </message>
  <message>
   <source>Net post to sideline</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>ネットポストからサイドラインまで</translation>
  </message>
  <message>
   <source>Service courts</source>
   <extracomment>[the field tennis]</extracomment>
   <translation>サービスコート</translation>
  </message>
  <message>
   <source>Net</source>
   <extracomment>[the field tennis, the field volleyball]</extracomment>
   <translation>ネット</translation>
  </message>
  <message>
   <source>Volleyball</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>バレーボール</translation>
  </message>
  <message>
   <source>Left attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左アタックライン</translation>
  </message>
  <message>
   <source>Right attack line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右アタックライン</translation>
  </message>
  <message>
   <source>Net's top band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>ネットの上部の白帯</translation>
  </message>
  <message>
   <source>Net's bottom band</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>ネットの下部の白帯</translation>
  </message>
  <message>
   <source>Far antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>奥のアンテナ</translation>
  </message>
  <message>
   <source>Near antenna</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>手前のアンテナ</translation>
  </message>
  <message>
   <source>Far post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>奥の支柱</translation>
  </message>
  <message>
   <source>Near post</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>手前の支柱</translation>
  </message>
  <message>
   <source>Left far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左奥の延長線</translation>
  </message>
  <message>
   <source>Left near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左手前の延長線</translation>
  </message>
  <message>
   <source>Right far extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右奥の延長線</translation>
  </message>
  <message>
   <source>Right near extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右手前の延長線</translation>
  </message>
  <message>
   <source>Left far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左奥のサービスマーク</translation>
  </message>
  <message>
   <source>Left near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>左手前のサービスマーク</translation>
  </message>
  <message>
   <source>Right far service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右奥のサービスマーク</translation>
  </message>
  <message>
   <source>Right near service mark</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>右手前のサービスマーク</translation>
  </message>
  <message>
   <source>Attack line to centre line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>アタックラインからセンターラインまで</translation>
  </message>
  <message>
   <source>Net height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>ネットの高さ</translation>
  </message>
  <message>
   <source>Net depth</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>ネットの縦幅</translation>
  </message>
  <message>
   <source>Net length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>ネットの長さ</translation>
  </message>
  <message>
   <source>Antenna above the net</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>ネットより上のアンテナ</translation>
  </message>
  <message>
   <source>Post to side line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>支柱からサイドラインまで</translation>
  </message>
  <message>
   <source>Post height</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>支柱の高さ</translation>
  </message>
  <message>
   <source>Attack line extension</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>アタックラインの延長</translation>
  </message>
  <message>
   <source>Service mark to end line</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>サービスマークからエンドラインまで</translation>
  </message>
  <message>
   <source>Service mark length</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>サービスマークの長さ</translation>
  </message>
  <message>
   <source>Marks outside the court</source>
   <extracomment>[the field volleyball]</extracomment>
   <translation>コート外のマーク</translation>
  </message>
 </context>
</TS>
