const RATE_HZ = 48_000
const FULL_SCALE = 32_767

/** What a browser recorded, as a WAV file in mono of 48 kHz and 16 bit. */
export async function wavOf(recorded: Blob): Promise<File> {
  const context = new OfflineAudioContext(1, 1, RATE_HZ)
  const decoded = await context.decodeAudioData(await recorded.arrayBuffer())
  const channels = Array.from({ length: decoded.numberOfChannels }, (_, at) => decoded.getChannelData(at))
  return new File([encodeWav(channels)], 'placeholder.wav', { type: 'audio/wav' })
}

/** Channels from −1 to 1, mixed to one and written as PCM. */
export function encodeWav(channels: readonly Float32Array[]): ArrayBuffer {
  const frames = channels[0]?.length ?? 0
  const view = new DataView(new ArrayBuffer(44 + 2 * frames))
  const text = (at: number, word: string) => {
    for (const [offset, letter] of [...word].entries()) view.setUint8(at + offset, letter.charCodeAt(0))
  }
  text(0, 'RIFF')
  view.setUint32(4, 36 + 2 * frames, true)
  text(8, 'WAVEfmt ')
  view.setUint32(16, 16, true)
  view.setUint16(20, 1, true)
  view.setUint16(22, 1, true)
  view.setUint32(24, RATE_HZ, true)
  view.setUint32(28, 2 * RATE_HZ, true)
  view.setUint16(32, 2, true)
  view.setUint16(34, 16, true)
  text(36, 'data')
  view.setUint32(40, 2 * frames, true)
  for (let frame = 0; frame < frames; frame++) {
    const sum = channels.reduce((total, samples) => total + (samples[frame] ?? 0), 0)
    const value = Math.max(-1, Math.min(1, sum / channels.length))
    view.setInt16(44 + 2 * frame, Math.round(value * FULL_SCALE), true)
  }
  return view.buffer
}
