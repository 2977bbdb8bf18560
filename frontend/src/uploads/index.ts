export { filesOfDrop, filesOfField, type Picked } from './drops'
export { partsTransport } from './parts'
export {
  type Figures,
  isGoing,
  type Transport,
  type TransportEvents,
  type Upload,
  UploadQueue,
  type UploadState,
} from './queue'
export { type Accepts, ANY_FILE, type FileKind } from './sniff'
export { smallFilesTransport } from './small'
export { tusTransport } from './tus'
export { useLeaveWarning, usePageDrop, useUploads } from './useUploads'
