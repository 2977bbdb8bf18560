/** A picture this far off is put in its place at once; a nearer one runs a little faster or slower until it is there. */
const JUMP_S = 0.15
/** Nobody sees less. */
const CLOSE_S = 0.004
const MOST_SPEED = 0.12
const CORRECTION_PER_S = 3

/** What of a video element is steered. */
export interface Picture {
  currentTime: number
  playbackRate: number
  readonly paused: boolean
  readonly seeking: boolean
  play: () => Promise<void>
  pause: () => void
}

/** Bring the picture to where the listener is, in seconds of the clip. */
export function syncPicture(picture: Picture, wantedS: number, isPlaying: boolean): void {
  const awayS = picture.currentTime - wantedS
  if (!isPlaying) {
    if (!picture.paused) picture.pause()
    if (!picture.seeking && Math.abs(awayS) > CLOSE_S) picture.currentTime = wantedS
    return
  }
  if (picture.paused) void picture.play().catch(() => undefined)
  if (picture.seeking) return
  if (Math.abs(awayS) > JUMP_S) {
    picture.currentTime = wantedS
    picture.playbackRate = 1
    return
  }
  const correction = Math.min(MOST_SPEED, Math.max(-MOST_SPEED, CORRECTION_PER_S * awayS))
  picture.playbackRate = Math.abs(awayS) > CLOSE_S ? 1 - correction : 1
}
